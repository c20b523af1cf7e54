#include "meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace velum_bench {
namespace {

using namespace velum;

Mesh mesh_of(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  return mesh;
}

/// The vertices on the middles of edges, each edge once.
class Midpoints {
 public:
  explicit Midpoints(std::vector<glm::vec3>& positions) : positions_(positions) {}
  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] =
        of_edge_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(positions_.size()));
    if (is_new) positions_.push_back((positions_[a] + positions_[b]) * 0.5f);
    return entry->second;
  }

 private:
  std::vector<glm::vec3>& positions_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> of_edge_;
};

float height_at(float x, float z) {
  return 0.12f * std::sin(5.0f * x + 1.0f) * std::cos(4.0f * z) + 0.05f * std::sin(13.0f * x - 9.0f * z) +
         0.02f * std::cos(31.0f * x) * std::sin(29.0f * z);
}

}  // namespace

Mesh without_attributes(Mesh mesh) {
  Mesh result;
  result.name = std::move(mesh.name);
  result.positions = std::move(mesh.positions);
  result.triangles = std::move(mesh.triangles);
  return result;
}

Mesh subdivided(const Mesh& mesh) {
  std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
  std::vector<glm::uvec3> triangles;
  triangles.reserve(mesh.triangles.size() * 4);
  Midpoints midpoints(positions);
  for (const glm::uvec3& t : mesh.triangles) {
    const std::uint32_t ab = midpoints.between(t.x, t.y);
    const std::uint32_t bc = midpoints.between(t.y, t.z);
    const std::uint32_t ca = midpoints.between(t.z, t.x);
    triangles.insert(triangles.end(), {{t.x, ab, ca}, {ab, t.y, bc}, {ca, bc, t.z}, {ab, bc, ca}});
  }
  return mesh_of(std::move(positions), std::move(triangles));
}

Mesh sphere_of(double triangles) {
  // Two triangles per cell, but one at the poles: 2 · segments · (rings - 1).
  const int rings = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles) / 2.0)));
  const int segments = std::max(3, static_cast<int>(std::lround(triangles / (2.0 * (rings - 1)))));
  return without_attributes(shapes::sphere(1.0f, segments, rings));
}

Mesh terrain_of(double triangles) {
  const int cells = std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 2.0))));
  const Mesh flat = shapes::grid(2.0f, cells);
  std::vector<glm::vec3> positions(flat.positions.begin(), flat.positions.end());
  for (glm::vec3& p : positions) p.y = height_at(p.x, p.z);
  return mesh_of(std::move(positions), {flat.triangles.begin(), flat.triangles.end()});
}

Mesh filling_quads(bool back_to_front, double vertical_angle, double aspect) {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  for (int i = 0; i < 32; ++i) {
    const double distance = 1.5 + 0.5 * (back_to_front ? 31 - i : i);
    const double y = 1.01 * distance * std::tan(vertical_angle / 2.0), x = y * aspect;
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      positions.emplace_back(sx * x, sy * y, -distance);
    triangles.insert(triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
  }
  return mesh_of(std::move(positions), std::move(triangles));
}

Scene thousand_times(Mesh mesh) {
  const Aabb box = bounds(mesh);
  const glm::dvec3 step = (glm::dvec3(box.upper) - glm::dvec3(box.lower)) * 1.2;
  Scene scene;
  const std::uint32_t index = scene.add_mesh(std::move(mesh));
  for (int i = 0; i < 1000; ++i) {
    Instance instance;
    instance.mesh = index;
    instance.world_from_object[3] = glm::dvec4(step * (glm::dvec3(i % 10, i / 10 % 10, i / 100) - 4.5), 1.0);
    scene.add_instance(instance);
  }
  return scene;
}

}  // namespace velum_bench
