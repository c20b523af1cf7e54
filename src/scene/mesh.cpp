#include "mesh.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "../base/error.hpp"
#include "../base/floating_point.hpp"

namespace velum {
namespace {

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string place_of(const Mesh& mesh) {
  return "mesh '" + mesh.name + "'";
}

template <typename T>
void require_length(const Mesh& mesh, const Array<T>& array, const char* array_name) {
  if (array.empty() || array.size() == mesh.positions.size()) return;
  throw Error(ErrorKind::usage,
              std::string(array_name) + " holds " + std::to_string(array.size()) + " elements for " +
                  std::to_string(mesh.positions.size()) + " positions",
              place_of(mesh), "leave it empty or give one element per position");
}

void require_index(const Mesh& mesh, const char* array_name, std::size_t element, std::uint32_t index) {
  if (index < mesh.positions.size()) return;
  throw Error(ErrorKind::usage,
              std::string(array_name) + "[" + std::to_string(element) + "] refers to vertex " +
                  std::to_string(index) + ", but there are " + std::to_string(mesh.positions.size()) +
                  " positions",
              place_of(mesh), "vertex indices count from 0");
}

/// The triangle's normal in double, twice its area long; zero where a vertex is not finite.
glm::dvec3 area_normal(const Mesh& mesh, const glm::uvec3& triangle) {
  const glm::vec3& a = mesh.positions[triangle.x];
  const glm::vec3& b = mesh.positions[triangle.y];
  const glm::vec3& c = mesh.positions[triangle.z];
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return glm::dvec3(0.0);
  return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
}

glm::vec3 unit_or_z(const glm::dvec3& v) {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0f, 0.0f, 1.0f);
}

/// Element by element through the triangles' indices: three elements of its own for every triangle.
template <typename T>
Array<T> unshared(const Array<T>& array, const Array<glm::uvec3>& triangles) {
  if (array.empty()) return {};
  std::vector<T> result;
  result.reserve(3 * triangles.size());
  for (const glm::uvec3& triangle : triangles) {
    result.push_back(array[triangle.x]);
    result.push_back(array[triangle.y]);
    result.push_back(array[triangle.z]);
  }
  return result;
}

}  // namespace

Aabb bounds(const Mesh& mesh) {
  Aabb box;
  for (const glm::vec3& position : mesh.positions) {
    if (is_finite(position)) box.include(glm::dvec3(position));
  }
  return box;
}

void validate(const Mesh& mesh) {
  require_length(mesh, mesh.normals, "normals");
  require_length(mesh, mesh.texture_coordinates, "texture_coordinates");
  require_length(mesh, mesh.colours, "colours");
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (glm::length_t c = 0; c < 3; ++c) require_index(mesh, "triangles", i, mesh.triangles[i][c]);
  }
  for (std::size_t i = 0; i < mesh.segments.size(); ++i) {
    for (glm::length_t c = 0; c < 2; ++c) require_index(mesh, "segments", i, mesh.segments[i][c]);
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i) require_index(mesh, "points", i, mesh.points[i]);
}

std::vector<glm::vec3> smooth_normals(const Mesh& mesh) {
  const FloatingPointScope floating_point;
  validate(mesh);
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0.0));
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 normal = area_normal(mesh, triangle);
    for (glm::length_t corner = 0; corner < 3; ++corner) sums[triangle[corner]] += normal;
  }
  std::vector<glm::vec3> normals;
  normals.reserve(sums.size());
  for (const glm::dvec3& sum : sums) normals.push_back(unit_or_z(sum));
  return normals;
}

Mesh with_flat_normals(const Mesh& mesh) {
  const FloatingPointScope floating_point;
  validate(mesh);
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3) {
    throw Error(ErrorKind::limit,
                "flat normals for " + std::to_string(mesh.triangles.size()) +
                    " triangles need more vertices than 32-bit indices can name",
                place_of(mesh), "split the mesh");
  }
  std::vector<glm::vec3> normals;
  std::vector<glm::uvec3> triangles;
  normals.reserve(3 * mesh.triangles.size());
  triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    const std::uint32_t first = static_cast<std::uint32_t>(normals.size());
    normals.insert(normals.end(), 3, unit_or_z(area_normal(mesh, triangle)));
    triangles.emplace_back(first, first + 1, first + 2);
  }
  return {mesh.name,
          unshared(mesh.positions, mesh.triangles),
          std::move(normals),
          unshared(mesh.texture_coordinates, mesh.triangles),
          unshared(mesh.colours, mesh.triangles),
          std::move(triangles),
          {},
          {}};
}

}  // namespace velum
