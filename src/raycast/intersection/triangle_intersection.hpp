#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "../../base/ray.hpp"

namespace velum {

/// The corners of a triangle.
struct Triangle {
  glm::dvec3 a{0.0}, b{0.0}, c{0.0};
};

/// Where the line of a ray meets a triangle: ray.at(t) = a·barycentric.x + b·barycentric.y + c·barycentric.z.
struct TriangleHit {
  double t = 0.0;
  glm::dvec3 barycentric{0.0};
};

// The two teaching versions: boundary included, both sides seen, any t. Neither promises that a line through
// an edge that two triangles share hits at least one of them: watertight.hpp does, and is what velum uses.
// Both return nothing for triangles without area and for rays in the triangle's plane.

/// First the plane, then the point's barycentric coordinates by dot products.
/// Source: the lecture "Interactive Computer Graphics 11". Its test "0 ≤ a ≤ 1, 0 ≤ b ≤ 1, a + b ≤ 1" asks
/// more than is needed: a ≥ 0, b ≥ 0, a + b ≤ 1 says it all.
std::optional<TriangleHit> intersect_by_plane(const Ray& ray, const Triangle& triangle);

/// Cramer's rule for t and two barycentric coordinates, without the plane.
/// Source: Möller & Trumbore 1997, "Fast, Minimum Storage Ray/Triangle Intersection". No epsilon: a threshold
/// on the determinant depends on the scene's unit of length and makes small triangles vanish. The listing in
/// the lecture "Interactive Computer Graphics 11" compares the *vector* t with its epsilon at the end, where
/// the parameter mu is meant.
std::optional<TriangleHit> intersect_moller_trumbore(const Ray& ray, const Triangle& triangle);

}  // namespace velum
