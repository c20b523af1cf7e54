#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

#include "../base/elementary.hpp"

namespace velum {

/// What the depth of a triangle and that of a segment are set up from alike.

/// The reversed depth r = 1 - z of a clip-space vertex. @pre v.w ≠ 0
inline double reversed_depth(const glm::dvec4& v) {
  return (v.w - v.z) * (1.0 / v.w);
}

/// The smallest and largest reversed depth among the vertices with w > 0.
struct VertexRange {
  double nearest = 0.0;
  double farthest = 1.0;
  int farthest_vertex = -1;
  bool all_in_front = true;  ///< every w > 0
};

inline VertexRange vertex_range(std::span<const glm::dvec4> vertices) {
  VertexRange range;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::dvec4& vertex = vertices[i];
    if (!(vertex.w > 0.0)) {
      range.all_in_front = false;
      continue;
    }
    const double r = reversed_depth(vertex);
    if (range.farthest_vertex < 0 || r < range.farthest) {
      range.farthest = r;
      range.farthest_vertex = static_cast<int>(i);
    }
    if (i == 0 || r > range.nearest) range.nearest = r;
  }
  return range;
}

/// The pixel column (row) of a coordinate, kept inside the picture.
inline std::int32_t pixel_of(double coordinate, int size) {
  return static_cast<std::int32_t>(elementary::floor(std::clamp(coordinate, 0.0, size - 1.0)));
}

/// Rounded once, in [0, 1]; never -0 or NaN.
inline float unit_float(double r) {
  return static_cast<float>(r > 0.0 ? (r < 1.0 ? r : 1.0) : 0.0);
}

/// Whether a slope would let a product overflow: what has it is seen edge-on (end-on) for all purposes.
inline bool is_steep(double slope) {
  constexpr double steepest = 1e30;
  return !(slope <= steepest && slope >= -steepest);
}

}  // namespace velum
