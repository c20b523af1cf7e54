#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace velum {

/// |ball_from_space·(p - centre)| ≤ 1.
struct EnclosingEllipsoid {
  glm::dvec3 centre{0.0};
  glm::dmat3 ball_from_space{1.0};
};

/// An ellipsoid around points with little more than the least volume, by Khachiyan's algorithm; of flat
/// points a thin one. @pre at least one, finite
EnclosingEllipsoid enclosing_ellipsoid(std::span<const glm::vec3> points);

/// The surface of an ellipsoid, by the midpoint rule: relative error below 1e-3, or 1e-2 for axes of 1 : 100.
double ellipsoid_area(const glm::dmat3& ball_from_space);

}  // namespace velum
