#include "camera_rays.hpp"

#include <cmath>
#include <limits>

namespace velum {
namespace {

glm::dvec3 divided(const glm::dvec4& p) {
  return glm::dvec3(p) / p.w;
}

/// From `start`, which is finite, towards `end`, which may lie at infinity or beyond; t from 0 to what is
/// returned.
ViewRay from_to(const glm::dvec4& start, const glm::dvec4& end) {
  constexpr double as_good_as_infinite = 0x1.0p-40;
  const glm::dvec3 origin = divided(start);
  if (end.w / start.w > as_good_as_infinite) return {{origin, divided(end) - origin}, {0.0, 1.0}};
  // A finite point between them instead: the share s of the way, where w is smaller by 2^20. There t = 1, and
  // t is proportional to s / w.
  const double s = (1.0 - 0x1.0p-20) * start.w / (start.w - end.w);
  const glm::dvec4 between = start + (end - start) * s;
  const double t = between.w / (s * end.w);
  const bool is_finite = end.w / start.w > 0.0;
  return {{origin, divided(between) - origin},
          {0.0, is_finite ? t : std::numeric_limits<double>::infinity()}};
}

}  // namespace

ViewRay CameraRays::through(double px, double py) const {
  const glm::dvec2 ndc = viewport_.ndc_from_pixel(px, py);
  const glm::dvec4 near = world_from_clip_ * glm::dvec4(ndc.x, ndc.y, 0.0, 1.0);
  const glm::dvec4 far = world_from_clip_ * glm::dvec4(ndc.x, ndc.y, 1.0, 1.0);
  if (std::fabs(near.w) >= std::fabs(far.w)) return from_to(near, far);
  // Started where the numbers are smaller, and turned about: t ≤ 0.
  const ViewRay back = from_to(far, near);
  return {{back.ray.origin, -back.ray.direction}, {-back.range.upper, 0.0}};
}

}  // namespace velum
