#include "oriented_box.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace velum {

OrientedBox oriented_box(std::span<const glm::vec3> points, const glm::dvec3& normal) {
  glm::dvec3 x(1.0, 0.0, 0.0), y(0.0, 1.0, 0.0), z(0.0, 0.0, 1.0);
  if (glm::dot(normal, normal) > 0.5) {
    z = normal;
    const glm::dvec3 other = std::abs(z.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    y = glm::cross(z, other);
    y /= std::sqrt(glm::dot(y, y));
    x = glm::cross(y, z);
  }
  glm::dvec3 lower(0.0), upper(0.0), reach(0.0);
  const glm::dvec3 origin(points[0]);
  for (const glm::vec3& point : points) {
    const glm::dvec3 from_origin = glm::dvec3(point) - origin;
    const glm::dvec3 along(glm::dot(from_origin, x), glm::dot(from_origin, y), glm::dot(from_origin, z));
    lower = glm::min(lower, along);
    upper = glm::max(upper, along);
    reach = glm::max(reach, glm::abs(glm::dvec3(point)));
  }
  // More than what rounds here, and what the axes are short of being orthogonal.
  const double margin =
      1e-14 * (reach.x + reach.y + reach.z) + 1e-13 * (glm::dot(upper - lower, glm::dvec3(1.0)));
  lower -= margin;
  upper += margin;
  const glm::dvec3 size = upper - lower;
  return {origin + ((x * lower.x + y * lower.y) + z * lower.z), x * size.x, y * size.y, z * size.z};
}

}  // namespace velum
