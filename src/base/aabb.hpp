#pragma once

#include <array>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace velum {

/// An axis-aligned box. Default: empty (lower = +infinity, upper = -infinity), the neutral element of
/// include().
struct Aabb {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

  bool is_empty() const { return !(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z); }
  glm::dvec3 centre() const { return lower + (upper - lower) * 0.5; }
  glm::dvec3 size() const { return upper - lower; }

  void include(const glm::dvec3& point) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  void include(const Aabb& other) {
    lower = glm::min(lower, other.lower);
    upper = glm::max(upper, other.upper);
  }

  /// The eight corners; bit 0, 1, 2 of the index chooses upper in x, y, z.
  std::array<glm::dvec3, 8> corners() const {
    std::array<glm::dvec3, 8> result;
    for (unsigned i = 0; i < 8; ++i) {
      result[i] = {(i & 1u) ? upper.x : lower.x, (i & 2u) ? upper.y : lower.y, (i & 4u) ? upper.z : lower.z};
    }
    return result;
  }
};

}  // namespace velum
