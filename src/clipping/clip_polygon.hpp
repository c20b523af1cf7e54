#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <span>

#include "outcode.hpp"

namespace velum {

/// A convex polygon in homogeneous clip space. A triangle gains at most one vertex per plane: 9.
struct ClippedPolygon {
  static constexpr int capacity = 9;
  std::array<glm::dvec4, capacity> vertices;
  int count = 0;
  Outcode cut_by = 0;  ///< planes that cut the polygon

  std::span<const glm::dvec4> span() const { return {vertices.data(), static_cast<std::size_t>(count)}; }
};

/// Clips a triangle against the canonical view volume (Sutherland & Hodgman 1974, homogeneous as Blinn &
/// Newell 1978), plane after plane in table order. Every output vertex has outcode 0, exactly. Each cut goes
/// from the inside to the outside end and *sets* the cut coordinate, so triangles that share an edge get the
/// same vertices and clipping twice changes nothing. An empty result has count 0.
ClippedPolygon clip_triangle(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c);

/// One plane's step, for those who want to watch: clips `polygon` against plane i only.
/// @param done  the planes that every vertex of the polygon is already inside of (bit i of table row i)
ClippedPolygon clip_against(const ClippedPolygon& polygon, ClipPlane plane, Outcode done);

}  // namespace velum
