#include "builtin_surface.hpp"

#include <glm/geometric.hpp>
#include <utility>

#include "../base/contract.hpp"
#include "../base/elementary.hpp"

namespace velum::shapes {

void SurfaceBuilder::paint(const glm::vec3& colour) {
  VELUM_REQUIRE(is_painted_ || positions_.empty(), {"vertices", positions_.size()});
  colour_ = glm::vec4(colour, 1.0f);
  is_painted_ = true;
}

std::uint32_t SurfaceBuilder::vertex(const SurfaceVertex& vertex) {
  // + 0.0 turns -0 into +0, so that equal positions have equal bits.
  positions_.push_back(glm::vec3(vertex.position + 0.0));
  normals_.push_back(glm::vec3(vertex.normal + 0.0));
  texture_coordinates_.push_back(glm::vec2(vertex.texture_coordinate));
  if (is_painted_) colours_.push_back(colour_);
  return static_cast<std::uint32_t>(positions_.size() - 1);
}

void SurfaceBuilder::flat_polygon(std::span<const glm::dvec3> corners, std::span<const glm::dvec2> uv) {
  const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const auto n = static_cast<std::int64_t>(corners.size());
  std::uint32_t first = 0;
  for (std::int64_t k = 0; k < n; ++k) {
    const auto corner = static_cast<std::size_t>(k);
    // Corner 0 stands half an edge before the lowest point, 3/4 of a turn.
    const glm::dvec2 regular = 0.5 + 0.5 * point_on_circle((4 * k + 3 * n - 2) % (4 * n), 4 * n);
    const std::uint32_t index = vertex({corners[corner], normal, uv.empty() ? regular : uv[corner]});
    if (k == 0) first = index;
    if (k >= 2) triangle(first, index - 1, index);
  }
}

Mesh SurfaceBuilder::finish(const std::string& name) {
  return {name,
          std::move(positions_),
          std::move(normals_),
          std::move(texture_coordinates_),
          std::move(colours_),
          std::move(triangles_)};
}

glm::dvec2 point_on_circle(std::int64_t k, std::int64_t n) {
  VELUM_REQUIRE(0 <= k && k < n, {"k", k}, {"n", n});
  // The angle is t/n quarter turns.
  std::int64_t t = 4 * k;
  const bool is_below = t > 2 * n;
  if (is_below) t = 4 * n - t;
  const bool is_left = t > n;
  if (is_left) t = 2 * n - t;
  const bool is_steep = 2 * t > n;
  if (is_steep) t = n - t;
  const double angle = 0.5 * pi * (static_cast<double>(t) / static_cast<double>(n));
  glm::dvec2 point(elementary::cos(angle), elementary::sin(angle));
  if (2 * t == n) point.y = point.x;  // on the diagonal
  if (is_steep) std::swap(point.x, point.y);
  return {is_left ? -point.x : point.x, is_below ? -point.y : point.y};
}

std::vector<glm::dvec2> circle(int n) {
  std::vector<glm::dvec2> points;
  points.reserve(static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k) points.push_back(point_on_circle(k, n));
  return points;
}

}  // namespace velum::shapes
