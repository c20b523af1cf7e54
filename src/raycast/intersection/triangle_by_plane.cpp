#include <glm/geometric.hpp>

#include "surface_hit.hpp"
#include "triangle_intersection.hpp"

namespace velum {

std::optional<TriangleHit> intersect_by_plane(const Ray& ray, const Triangle& triangle) {
  const glm::dvec3 a = triangle.b - triangle.a;
  const glm::dvec3 b = triangle.c - triangle.a;
  const glm::dvec3 normal = glm::cross(a, b);
  const double slope = glm::dot(ray.direction, normal);
  const double aa = glm::dot(a, a), ab = glm::dot(a, b), bb = glm::dot(b, b);
  const double area2 = aa * bb - ab * ab;
  if (!is_usable(ray) || slope == 0.0 || !(area2 > 0.0)) return {};
  const double t = glm::dot(triangle.a - ray.origin, normal) / slope;
  const glm::dvec3 q = ray.at(t) - triangle.a;
  const double qa = glm::dot(q, a), qb = glm::dot(q, b);
  const double alpha = (bb * qa - ab * qb) / area2;
  const double beta = (aa * qb - ab * qa) / area2;
  if (!(alpha >= 0.0 && beta >= 0.0 && alpha + beta <= 1.0)) return {};
  return TriangleHit{t, {1.0 - alpha - beta, alpha, beta}};
}

}  // namespace velum
