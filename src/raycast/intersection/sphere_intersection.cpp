#include "sphere_intersection.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace velum {

Interval ball_interval(const glm::dvec3& offset, const glm::dvec3& direction, double radius) {
  const double a = glm::dot(direction, direction);
  const double outside = glm::dot(offset, offset) - radius * radius;
  if (!(a > 0.0)) return outside <= 0.0 ? Interval{} : Interval::empty();
  const double half_b = glm::dot(offset, direction);
  const glm::dvec3 perpendicular = offset - direction * (half_b / a);
  const double discriminant = radius * radius - glm::dot(perpendicular, perpendicular);
  if (!(discriminant >= 0.0)) return Interval::empty();
  const double root = std::sqrt(a * discriminant);
  const double q = -(half_b + (half_b < 0.0 ? -root : root));
  if (q == 0.0) return {0.0, 0.0};  // the line touches at the ray's origin
  const double one = q / a;
  const double other = outside / q;
  return one < other ? Interval{one, other} : Interval{other, one};
}

SurfaceHits intersect(const Ray& ray, const Sphere& sphere) {
  SurfaceHits result;
  if (!is_usable(ray) || !(sphere.radius > 0.0)) return result;
  const Interval inside = ball_interval(ray.origin - sphere.centre, ray.direction, sphere.radius);
  if (inside.is_empty()) return result;
  const auto add = [&](double t) { result.add({t, glm::normalize(ray.at(t) - sphere.centre)}); };
  add(inside.lower);
  if (inside.upper > inside.lower) add(inside.upper);
  return result;
}

}  // namespace velum
