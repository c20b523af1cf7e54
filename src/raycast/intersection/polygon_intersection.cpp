#include "polygon_intersection.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "plane_intersection.hpp"

namespace velum {
namespace {

/// Twice the area vector (Newell): right for concave outlines too.
glm::dvec3 area_vector(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return sum;
}

std::optional<SurfaceHit> hit_of_plane(const Ray& ray, std::span<const glm::dvec3> corners,
                                       const glm::dvec3& normal) {
  if (corners.size() < 3 || normal == glm::dvec3(0.0)) return {};
  return intersect(ray, Plane{normal, -glm::dot(normal, corners[0])});
}

/// Leaves out the axis along which the polygon is thinnest.
struct Flattening {
  int u, v;
  explicit Flattening(const glm::dvec3& normal) {
    const glm::dvec3 size(std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z));
    const int dropped = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    u = (dropped + 1) % 3;
    v = (dropped + 2) % 3;
  }
  glm::dvec2 operator()(const glm::dvec3& p) const { return {p[u], p[v]}; }
};

}  // namespace

std::optional<SurfaceHit> intersect_convex_polygon(const Ray& ray, std::span<const glm::dvec3> corners) {
  const glm::dvec3 normal = area_vector(corners);
  const std::optional<SurfaceHit> hit = hit_of_plane(ray, corners, normal);
  if (!hit) return {};
  const glm::dvec3 q = ray.at(hit->t);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& a = corners[i];
    const glm::dvec3& b = corners[(i + 1) % corners.size()];
    if (!(glm::dot(normal, glm::cross(b - a, q - a)) >= 0.0)) return {};
  }
  return hit;
}

std::optional<SurfaceHit> intersect_polygon(const Ray& ray, std::span<const glm::dvec3> corners) {
  const glm::dvec3 normal = area_vector(corners);
  const std::optional<SurfaceHit> hit = hit_of_plane(ray, corners, normal);
  if (!hit) return {};
  const Flattening flat(normal);
  const glm::dvec2 q = flat(ray.at(hit->t));
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a = flat(corners[i]);
    const glm::dvec2 b = flat(corners[(i + 1) % corners.size()]);
    if ((a.y <= q.y) == (b.y <= q.y)) continue;
    if (q.x < a.x + (b.x - a.x) * ((q.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  if (!inside) return {};
  return hit;
}

}  // namespace velum
