#pragma once

#include <glm/vec3.hpp>

#include "../../base/aabb.hpp"
#include "../../base/ray.hpp"
#include "interval.hpp"

namespace velum {

/// A ray made ready to meet many boxes and triangles that all lie in known bounds.
///
/// Every box is met as if it were larger by `margin` on each side, which is more than all rounding on the way
/// to a hit can amount to (Ize 2013, "Robust BVH Ray Traversal", widens the interval instead; an absolute
/// margin also covers the rounding of the triangles' vertices). Rounding is monotone, so of two boxes, one
/// inside the other, the inner has the inner interval, to the bit. And a triangle's hit is put inside the
/// interval of the triangle's own box. Together: **no box around a triangle is ever missed by a ray that hits
/// the triangle, nor entered after the hit**, and so every structure finds what brute force finds.
struct PreparedRay {
  Ray ray;
  Interval range;         ///< the t that are wanted
  bool usable = false;    ///< otherwise it hits nothing
  double margin = 0.0;    ///< in the space of the ray
  glm::dvec3 ahead{0.0};  ///< origin + margin, from which lower sides are seen
  glm::dvec3 behind{0.0};
  glm::dvec3 inverse{0.0};  ///< 1 / direction, at most 2^1000
  // The shear and scale that make the ray run along its longest axis kz: Woop, Benthin & Wald 2013.
  int kx = 0, ky = 1, kz = 2;
  double shear_x = 0.0, shear_y = 0.0, scale_z = 1.0;

  /// @param bounds  holds everything that is to be met
  PreparedRay(const Ray& ray_in, const Interval& range_in, const Aabb& bounds);

  /// Where the ray is inside a box (with its margin); unlimited by `range`.
  /// @tparam Vector  glm::dvec3 or glm::vec3
  template <typename Vector>
  Interval through(const Vector& lower, const Vector& upper) const {
    Interval inside;
    for (int axis = 0; axis < 3; ++axis) {
      const double one = (static_cast<double>(lower[axis]) - ahead[axis]) * inverse[axis];
      const double other = (static_cast<double>(upper[axis]) - behind[axis]) * inverse[axis];
      const double entry = one < other ? one : other;
      const double exit = one < other ? other : one;
      inside.lower = entry > inside.lower ? entry : inside.lower;
      inside.upper = exit < inside.upper ? exit : inside.upper;
    }
    return inside;
  }
};

}  // namespace velum
