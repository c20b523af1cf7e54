#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

#include "mesh.hpp"

/// What the built-in shapes are put together from. Everything is computed in double and rounded to float
/// once, so equal double positions stay equal and shapes close bit by bit.
namespace velum::shapes {

struct SurfaceVertex {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  ///< unit length
  glm::dvec2 texture_coordinate{0.0};
};

/// Collects vertices and triangles and hands them over as a Mesh.
class SurfaceBuilder {
 public:
  /// Colours all vertices that follow (linear). To be called before the first vertex, or never.
  void paint(const glm::vec3& colour);

  /// @return its index
  std::uint32_t vertex(const SurfaceVertex& vertex);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { triangles_.emplace_back(a, b, c); }
  /// A plane convex polygon with vertices of its own: counter-clockwise seen from outside.
  /// @param uv one per corner, or empty: a regular polygon that stands on its first edge, filling the texture
  void flat_polygon(std::span<const glm::dvec3> corners, std::span<const glm::dvec2> uv = {});

  /// @pre it is not used afterwards
  Mesh finish(const std::string& name);

 private:
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec3> normals_;
  std::vector<glm::vec2> texture_coordinates_;
  std::vector<glm::vec4> colours_;
  std::vector<glm::uvec3> triangles_;
  glm::vec4 colour_{1.0f};
  bool is_painted_ = false;
};

/// (cos, sin) of the angle 2π·k/n. Exact at the quarter turns and symmetric about the axes and the diagonals:
/// only angles of the first eighth are computed, the others are mirrored. @pre 0 ≤ k < n
glm::dvec2 point_on_circle(std::int64_t k, std::int64_t n);
/// All n of them.
std::vector<glm::dvec2> circle(int n);

/// A quadrilateral lattice of (columns+1)·(rows+1) vertices at(column, row), row after row; seen from
/// outside, columns run to the right and rows upwards.
/// @return the index of the first; (column, row) is row·(columns+1) + column further on
template <typename At>
std::uint32_t add_lattice(SurfaceBuilder& builder, int columns, int rows, At&& at) {
  std::uint32_t first = 0;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const std::uint32_t index = builder.vertex(at(column, row));
      if (row == 0 && column == 0) first = index;
    }
  }
  const auto index = [&](int column, int row) {
    return first + static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(columns + 1) +
           static_cast<std::uint32_t>(column);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      builder.triangle(index(column, row), index(column + 1, row), index(column + 1, row + 1));
      builder.triangle(index(column, row), index(column + 1, row + 1), index(column, row + 1));
    }
  }
  return first;
}

enum class Apex { above, below };

/// Triangles from a ring of columns+1 vertices (from index `ring` on, running to the right seen from outside)
/// to apex(column), an index for every column.
template <typename ApexAt>
void add_fan(SurfaceBuilder& builder, std::uint32_t ring, int columns, Apex where, ApexAt&& apex) {
  for (int column = 0; column < columns; ++column) {
    const std::uint32_t left = ring + static_cast<std::uint32_t>(column);
    if (where == Apex::above) builder.triangle(left, left + 1, apex(column));
    if (where == Apex::below) builder.triangle(apex(column), left + 1, left);
  }
}

}  // namespace velum::shapes
