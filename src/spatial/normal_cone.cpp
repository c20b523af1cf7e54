#include "normal_cone.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace velum {
namespace {

struct Corners {
  glm::dvec3 a, b, c;
};

Corners corners_of(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                   std::size_t triangle) {
  return {glm::dvec3(positions[indices[3 * triangle]]), glm::dvec3(positions[indices[3 * triangle + 1]]),
          glm::dvec3(positions[indices[3 * triangle + 2]])};
}

/// As long as the doubled area.
glm::dvec3 normal_of(const Corners& t) {
  return glm::cross(t.b - t.a, t.c - t.a);
}

double longest_edge_of(const Corners& t) {
  return std::sqrt(std::max(
      {glm::dot(t.b - t.a, t.b - t.a), glm::dot(t.c - t.b, t.c - t.b), glm::dot(t.a - t.c, t.a - t.c)}));
}

}  // namespace

NormalCone normal_cone(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices) {
  constexpr double rounding = 1e-9;  // far more than the errors of all that is computed here
  NormalCone cone;
  const std::size_t count = indices.size() / 3;
  glm::dvec3 sum(0.0);
  cone.smallest_area = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const Corners triangle = corners_of(positions, indices, i);
    const glm::dvec3 normal = normal_of(triangle);
    const double area = std::sqrt(glm::dot(normal, normal));
    if (!(area > 0.0)) return {};
    sum += normal / area;
    cone.smallest_area = std::min(cone.smallest_area, area);
    cone.longest_edge = std::max(cone.longest_edge, longest_edge_of(triangle));
  }
  const double length = std::sqrt(glm::dot(sum, sum));
  if (!(length > rounding)) return {};
  cone.axis = sum / length;
  cone.cosine = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 normal = normal_of(corners_of(positions, indices, i));
    cone.cosine = std::min(cone.cosine, glm::dot(normal, cone.axis) / std::sqrt(glm::dot(normal, normal)));
  }
  cone.cosine -= rounding;
  cone.sine = std::min(std::sqrt(std::max(1.0 - cone.cosine * cone.cosine, 0.0)) + rounding, 1.0);
  cone.is_valid = cone.cosine > 0.0;
  return cone;
}

}  // namespace velum
