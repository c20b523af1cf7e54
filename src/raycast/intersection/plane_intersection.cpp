#include "plane_intersection.hpp"

#include <glm/geometric.hpp>

namespace velum {

std::optional<SurfaceHit> intersect(const Ray& ray, const Plane& plane) {
  const double slope = glm::dot(plane.normal, ray.direction);
  if (!is_usable(ray) || slope == 0.0) return {};
  return SurfaceHit{-plane.signed_value(ray.origin) / slope, glm::normalize(plane.normal)};
}

std::optional<SurfaceHit> intersect(const Ray& ray, const Rectangle& rectangle) {
  const glm::dvec3 normal = glm::cross(rectangle.u, rectangle.v);
  const double area2 = glm::dot(normal, normal);
  if (area2 == 0.0) return {};
  const std::optional<SurfaceHit> hit = intersect(ray, Plane{normal, -glm::dot(normal, rectangle.corner)});
  if (!hit) return {};
  const glm::dvec3 q = ray.at(hit->t) - rectangle.corner;
  const double a = glm::dot(glm::cross(q, rectangle.v), normal) / area2;
  const double b = glm::dot(glm::cross(rectangle.u, q), normal) / area2;
  if (!(a >= 0.0 && a <= 1.0 && b >= 0.0 && b <= 1.0)) return {};
  return hit;
}

}  // namespace velum
