#pragma once

#include "../../base/ray.hpp"
#include "interval.hpp"
#include "surface_hit.hpp"

namespace velum {

struct Sphere {
  glm::dvec3 centre{0.0};
  double radius = 1.0;
};

/// For which t the point `offset` + t·direction is within `radius` of 0. A direction 0 gives all or nothing.
///
/// The quadratic |offset + t·direction|² = radius² solved without cancellation: the discriminant from the
/// vector that is perpendicular to the direction, and only the root whose parts have the same sign by
/// addition, the other from the product of the roots. The lecture's formula (for |direction| = 1) subtracts
/// numbers that are nearly equal when the sphere is far away or the origin near its surface.
/// Source: Haines, Günther & Akenine-Möller 2019, "Precision Improvements for Ray/Sphere Intersection".
Interval ball_interval(const glm::dvec3& offset, const glm::dvec3& direction, double radius);

SurfaceHits intersect(const Ray& ray, const Sphere& sphere);

}  // namespace velum
