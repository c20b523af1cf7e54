#include "cylinder_intersection.hpp"

#include <glm/geometric.hpp>

#include "sphere_intersection.hpp"

namespace velum {
namespace {

/// For which t the value a + t·b is in 0 … 1.
Interval unit_interval(double a, double b) {
  if (b == 0.0) return a >= 0.0 && a <= 1.0 ? Interval{} : Interval::empty();
  const double at_0 = -a / b;
  const double at_1 = (1.0 - a) / b;
  return b > 0.0 ? Interval{at_0, at_1} : Interval{at_1, at_0};
}

/// A cylinder as the ray meets it: offset and direction in parts along the axis (α) and across it.
struct Parts {
  glm::dvec3 axis;
  glm::dvec3 across_offset, across_direction;
  Interval in_tube, between_ends;

  Parts(const Ray& ray, const Cylinder& cylinder, const glm::dvec3& axis_in) : axis(axis_in) {
    const double length2 = glm::dot(axis, axis);
    const glm::dvec3 offset = ray.origin - cylinder.first;
    const double alpha = glm::dot(offset, axis) / length2;
    const double alpha_step = glm::dot(ray.direction, axis) / length2;
    across_offset = offset - axis * alpha;
    across_direction = ray.direction - axis * alpha_step;
    in_tube = ball_interval(across_offset, across_direction, cylinder.radius);
    between_ends = unit_interval(alpha, alpha_step);
  }

  glm::dvec3 side_normal(double t) const { return glm::normalize(across_offset + across_direction * t); }
};

}  // namespace

SurfaceHits intersect(const Ray& ray, const Cylinder& cylinder) {
  SurfaceHits result;
  const glm::dvec3 axis = cylinder.second - cylinder.first;
  if (!is_usable(ray) || !(cylinder.radius > 0.0) || !(glm::dot(axis, axis) > 0.0)) return result;
  const Parts parts(ray, cylinder, axis);
  const Interval inside = velum::intersect(parts.in_tube, parts.between_ends);
  if (inside.is_empty()) return result;
  const bool towards_second = glm::dot(ray.direction, axis) > 0.0;
  const glm::dvec3 cap = glm::normalize(axis) * (towards_second ? -1.0 : 1.0);  // of the cap that is entered
  if (parts.in_tube.lower >= parts.between_ends.lower) {
    result.add({inside.lower, parts.side_normal(inside.lower)});
  } else if (cylinder.has_caps) {
    result.add({inside.lower, cap});
  }
  if (!(inside.upper > inside.lower)) return result;
  if (parts.in_tube.upper <= parts.between_ends.upper) {
    result.add({inside.upper, parts.side_normal(inside.upper)});
  } else if (cylinder.has_caps) {
    result.add({inside.upper, -cap});
  }
  return result;
}

}  // namespace velum
