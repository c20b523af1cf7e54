#include "ellipsoid_intersection.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "sphere_intersection.hpp"

namespace velum {

SurfaceHits intersect(const Ray& ray, const Ellipsoid& ellipsoid) {
  if (!is_usable(ray)) return {};
  const glm::dmat4 unit_from_world = glm::inverse(ellipsoid.world_from_unit);
  const Ray in_unit = transformed(unit_from_world, ray);
  SurfaceHits result = intersect(in_unit, Sphere{});
  const glm::dmat3 normals = glm::transpose(glm::dmat3(unit_from_world));
  for (int i = 0; i < result.count; ++i) {
    SurfaceHit& hit = result.hits[static_cast<std::size_t>(i)];
    hit.normal = glm::normalize(normals * hit.normal);
  }
  return result;
}

}  // namespace velum
