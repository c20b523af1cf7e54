#include "prepared_ray.hpp"

#include <cmath>

#include "surface_hit.hpp"

namespace velum {
namespace {

/// A multiple of the unit roundoff that leaves room: shearing a vertex rounds three times, a box's side
/// three times, an edge function twice.
constexpr double margin_factor = 32.0 * 0x1.0p-53;

/// The largest distance along an axis from the origin to anything in the bounds.
double reach(const glm::dvec3& origin, const Aabb& bounds) {
  double result = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    result = std::max(result, std::fabs(bounds.lower[axis] - origin[axis]));
    result = std::max(result, std::fabs(bounds.upper[axis] - origin[axis]));
  }
  return result;
}

/// 1 / v, kept finite, so that no product with it is NaN.
double bounded_inverse(double v) {
  constexpr double largest = 0x1.0p1000;
  if (std::fabs(v) > 1.0 / largest) return 1.0 / v;
  return v < 0.0 ? -largest : largest;
}

/// No branch: the axis of one ray tells nothing about the next one's.
int longest_axis(const glm::dvec3& v) {
  const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
  const bool is_x = x > y;
  const bool is_z = !(std::max(x, y) > z);
  return is_z ? 2 : 1 - static_cast<int>(is_x);
}

}  // namespace

PreparedRay::PreparedRay(const Ray& ray_in, const Interval& range_in, const Aabb& bounds)
    : ray(ray_in), range(range_in), usable(is_usable(ray_in) && !bounds.is_empty()) {
  if (!usable) return;
  margin = margin_factor * reach(ray.origin, bounds);
  ahead = ray.origin + margin;
  behind = ray.origin - margin;
  for (int axis = 0; axis < 3; ++axis) inverse[axis] = bounded_inverse(ray.direction[axis]);
  kz = longest_axis(ray.direction);
  constexpr int next[3] = {1, 2, 0};
  kx = next[kz];
  ky = next[kx];
  scale_z = inverse[kz];
  shear_x = ray.direction[kx] * scale_z;
  shear_y = ray.direction[ky] * scale_z;
}

}  // namespace velum
