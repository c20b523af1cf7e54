#include "box_intersection.hpp"

#include "surface_hit.hpp"

namespace velum {
namespace {

/// For which t the coordinate p + t·v is between lower and upper.
Interval slab_interval(double p, double v, double lower, double upper) {
  if (v == 0.0) return lower <= p && p <= upper ? Interval{} : Interval::empty();
  const double at_lower = (lower - p) / v;
  const double at_upper = (upper - p) / v;
  return v > 0.0 ? Interval{at_lower, at_upper} : Interval{at_upper, at_lower};
}

/// a unless it is larger or NaN.
double lesser(double a, double b) {
  return a < b ? a : b;
}
double greater(double a, double b) {
  return a > b ? a : b;
}

}  // namespace

Interval box_interval_by_cases(const Ray& ray, const Aabb& box) {
  if (!is_usable(ray) || box.is_empty()) return Interval::empty();
  Interval inside;
  for (int axis = 0; axis < 3; ++axis) {
    inside = intersect(
        inside, slab_interval(ray.origin[axis], ray.direction[axis], box.lower[axis], box.upper[axis]));
  }
  return inside;
}

Interval box_interval_branchless(const Ray& ray, const Aabb& box) {
  if (!is_usable(ray) || box.is_empty()) return Interval::empty();
  Interval inside;
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1.0 / ray.direction[axis];
    const double at_lower = (box.lower[axis] - ray.origin[axis]) * inverse;
    const double at_upper = (box.upper[axis] - ray.origin[axis]) * inverse;
    // A NaN stands for "in the boundary plane": the second operand, what was known before, is taken instead.
    const bool swapped = inverse < 0.0;
    inside.lower = greater(swapped ? at_upper : at_lower, inside.lower);
    inside.upper = lesser(swapped ? at_lower : at_upper, inside.upper);
  }
  return inside;
}

}  // namespace velum
