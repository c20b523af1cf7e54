#include "missing_normals.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "memory_bound.hpp"

namespace velum {
namespace {

glm::vec3 unit_or_zero(const glm::dvec3& v) {
  // Scaled by the largest component first, so that the squares neither overflow nor vanish.
  const double largest = std::max({v.x < 0 ? -v.x : v.x, v.y < 0 ? -v.y : v.y, v.z < 0 ? -v.z : v.z});
  if (!(largest > 0.0) || largest - largest != 0.0) return glm::vec3(0.0f);
  const glm::dvec3 scaled = v / largest;
  const double length = std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);
  if (!(length > 0.0)) return glm::vec3(0.0f);  // a NaN component
  return glm::vec3(scaled / length);
}

bool is_finite(const glm::vec3& p) {
  return p.x - p.x == 0.0f && p.y - p.y == 0.0f && p.z - p.z == 0.0f;
}

// Per triangle: the mesh it comes from, and three vertices of its own.
std::size_t flat_bytes(const Mesh& mesh) {
  std::size_t per_vertex = 2 * sizeof(glm::vec3);
  if (!mesh.texture_coordinates.empty()) per_vertex += sizeof(glm::vec2);
  if (!mesh.colours.empty()) per_vertex += sizeof(glm::vec4);
  return mesh.triangles.size() * (2 * sizeof(glm::uvec3) + 3 * per_vertex);
}

std::vector<glm::vec3> repaired_normals(const Mesh& mesh) {
  std::vector<glm::vec3> normals(mesh.normals.begin(), mesh.normals.end());
  bool is_complete = true;
  for (glm::vec3& normal : normals) {
    normal = unit_or_zero(glm::dvec3(normal));
    is_complete = is_complete && normal != glm::vec3(0.0f);
  }
  if (is_complete) return normals;
  const std::vector<glm::vec3> smooth = smooth_normals(mesh);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (normals[i] == glm::vec3(0.0f)) normals[i] = smooth[i];
  }
  return normals;
}

}  // namespace

glm::vec3 unit_or_zero(const glm::vec3& v) {
  return unit_or_zero(glm::dvec3(v));
}

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return unit_or_zero(glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)));
}

Mesh with_complete_normals(Mesh mesh, MissingNormals missing, std::size_t file_bytes,
                           const std::string& where) {
  if (!mesh.normals.empty()) {
    mesh.normals = repaired_normals(mesh);
  } else if (missing == MissingNormals::smooth) {
    mesh.normals = smooth_normals(mesh);
  } else {
    require_within_memory_bound(flat_bytes(mesh), file_bytes, "the triangles with flat normals", where);
    mesh = with_flat_normals(mesh);
  }
  return mesh;
}

void note_positions_not_finite(std::span<const glm::vec3> positions, std::vector<std::string>& notes) {
  const auto count =
      std::count_if(positions.begin(), positions.end(), [](const glm::vec3& p) { return !is_finite(p); });
  if (count == 0) return;
  notes.push_back(std::to_string(count) +
                  " vertex positions are not finite; triangles with them are not drawn");
}

}  // namespace velum
