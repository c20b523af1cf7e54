#include <glm/geometric.hpp>

#include "surface_hit.hpp"
#include "triangle_intersection.hpp"

namespace velum {

std::optional<TriangleHit> intersect_moller_trumbore(const Ray& ray, const Triangle& triangle) {
  const glm::dvec3 edge1 = triangle.b - triangle.a;
  const glm::dvec3 edge2 = triangle.c - triangle.a;
  const glm::dvec3 p = glm::cross(ray.direction, edge2);
  const double determinant = glm::dot(edge1, p);
  if (!is_usable(ray) || determinant == 0.0) return {};
  const double inverse = 1.0 / determinant;
  const glm::dvec3 from_a = ray.origin - triangle.a;
  const double u = glm::dot(from_a, p) * inverse;
  if (!(u >= 0.0 && u <= 1.0)) return {};
  const glm::dvec3 q = glm::cross(from_a, edge1);
  const double v = glm::dot(ray.direction, q) * inverse;
  if (!(v >= 0.0 && u + v <= 1.0)) return {};
  return TriangleHit{glm::dot(edge2, q) * inverse, {1.0 - u - v, u, v}};
}

}  // namespace velum
