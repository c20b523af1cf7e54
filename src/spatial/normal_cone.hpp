#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace velum {

/// Holds the normals of a group of triangles (Shirman & Abi-Ezzi 1993, "The Cone of Normals Technique for
/// Fast Processing of Curved Patches"), in object space.
struct NormalCone {
  glm::dvec3 axis{0.0};        ///< unit length
  double cosine = -1.0;        ///< of the largest angle between the axis and a normal, rounded down
  double sine = 0.0;           ///< of the same, rounded up
  double smallest_area = 0.0;  ///< of the triangles, doubled
  double longest_edge = 0.0;
  /// False where some triangle has no normal, or the normals point into more than a half-space.
  bool is_valid = false;
};

/// @param positions  object space, finite
/// @param indices    three per triangle
NormalCone normal_cone(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices);

}  // namespace velum
