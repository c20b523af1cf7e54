#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "../base/plane.hpp"

namespace velum {

/// One convex volume around everything, from the cheapest to meet to the tightest.
enum class VolumeKind {
  sphere,       ///< near the smallest: Bădoiu & Clarkson 2003, "Smaller Core-Sets for Balls"
  ellipsoid,    ///< near the one of least volume: Khachiyan 1996, "Rounding of Polytopes in the Real Number
                ///< Model"
  aabb,         ///< the 6-DOP: slabs across the axes
  dop14,        ///< with slabs across the 4 diagonals of a cube
  dop18,        ///< slabs across the axes and the 6 diagonals of its faces
  dop26,        ///< all of these
  convex_hull,  ///< by the library Qhull; see convex_hull.hpp
};

/// What a kind is called.
struct VolumeName {
  const char* name;
  VolumeKind kind;
};
std::span<const VolumeName> volume_names();

/// A ball under an affine map, or what is on the inner side of all planes. Holds its points but for less than
/// 2⁻⁴⁰ of its size.
struct BoundingVolume {
  VolumeKind kind = VolumeKind::aabb;
  double area = 0.0;          ///< of the surface; rays through one convex volume meet another inside it in
                              ///< proportion to their areas
  std::vector<Plane> planes;  ///< unit normals that point out; none for round volumes
  glm::dvec3 centre{0.0};     ///< of a round volume,
  glm::dmat3 ball_from_space{1.0};  ///< and |ball_from_space·(p - centre)| ≤ 1 is its inside

  bool is_round() const { return planes.empty(); }
  std::size_t memory() const { return sizeof(BoundingVolume) + planes.size() * sizeof(Plane); }
};

/// @param points  finite, at least one. Of flat ones the convex hull is taken to be the 26-DOP.
/// @throws Error (usage) for a convex hull where velum was built without Qhull
BoundingVolume bounding_volume(VolumeKind kind, std::span<const glm::vec3> points);

/// A ball around points; the radius is at most 1 % above the smallest. @pre at least one, finite
struct EnclosingBall {
  glm::dvec3 centre{0.0};
  double radius = 0.0;
};
EnclosingBall enclosing_ball(std::span<const glm::vec3> points);

/// The surface of a bounded polytope. @param size  more than its diameter
double polytope_area(std::span<const Plane> planes, const glm::dvec3& inside, double size);

}  // namespace velum
