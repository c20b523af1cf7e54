#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "../base/aabb.hpp"
#include "intersection/triangle_intersection.hpp"

namespace velum {

/// The triangles of one mesh, in object space. Views the caller's memory.
struct TriangleSet {
  std::span<const glm::vec3> positions;
  std::span<const glm::uvec3> triangles;

  std::uint32_t size() const { return static_cast<std::uint32_t>(triangles.size()); }

  /// @pre i < size()
  Triangle operator[](std::uint32_t i) const {
    const glm::uvec3& v = triangles[i];
    return {glm::dvec3(positions[v.x]), glm::dvec3(positions[v.y]), glm::dvec3(positions[v.z])};
  }
};

/// An axis-aligned box in float, exact for what is given in float. Empty: lower > upper.
struct Box {
  glm::vec3 lower{std::numeric_limits<float>::infinity()};
  glm::vec3 upper{-std::numeric_limits<float>::infinity()};

  bool is_empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
  glm::vec3 size() const { return upper - lower; }
  void include(const glm::vec3& p) {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  void include(const Box& other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }
  /// Half the surface: what the surface-area heuristic compares. 0 for an empty box.
  double half_area() const {
    if (is_empty()) return 0.0;
    const glm::dvec3 s = glm::dvec3(upper) - glm::dvec3(lower);
    return s.x * s.y + s.y * s.z + s.z * s.x;
  }
};

/// What a structure sorts: a box and whose it is.
struct BoxedItem {
  Box box;
  std::uint32_t id = 0;

  /// Twice the centre along an axis; no rounding can change the order of equal boxes.
  float centre(int axis) const { return box.lower[axis] + box.upper[axis]; }
};

inline Box box_around(std::span<const BoxedItem> items) {
  Box box;
  for (const BoxedItem& item : items) box.include(item.box);
  return box;
}

}  // namespace velum
