#pragma once

#include "../../base/ray.hpp"
#include "surface_hit.hpp"

namespace velum {

/// A finite cylinder: the axis runs from one end point to the other.
struct Cylinder {
  glm::dvec3 first{0.0};
  glm::dvec3 second{0.0, 0.0, 1.0};
  double radius = 1.0;
  bool has_caps = true;  ///< closed by two discs; otherwise an open tube
};

/// Where a line meets a cylinder's surface: that of the open tube is hit from inside through its open ends.
///
/// Two intervals of t: inside the infinite cylinder (|q| ≤ radius for the part q perpendicular to the axis),
/// and between the planes of the ends (0 ≤ α ≤ 1). With caps the surface is where their common part begins
/// and ends; without, where the first one does, as far as that is between the planes.
/// The lecture "Interactive Computer Graphics 11" writes the axis as Δp = p1 - p2 and then uses p1 + α·Δp
/// with 0 ≤ α ≤ 1, which runs away from p2: here the axis is second - first.
SurfaceHits intersect(const Ray& ray, const Cylinder& cylinder);

}  // namespace velum
