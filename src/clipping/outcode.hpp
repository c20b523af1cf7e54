#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>

namespace velum {

/// The six planes of the canonical view volume in the order of the lecture's bits. Bit i of an outcode is row
/// i of the table.
enum class ClipPlane : int { front = 0, behind = 1, left = 2, right = 3, below = 4, above = 5 };
inline constexpr int clip_plane_count = 6;

/// A vertex is inside plane i if dot(clip_planes[i], vertex) ≥ 0, homogeneous.
/// 0 in front (before near): z ≥ 0 · 1 behind (beyond far): w - z ≥ 0 · 2 left: x + w ≥ 0 · 3 right: w - x ≥
/// 0 · 4 below: y + w ≥ 0 · 5 above: w - y ≥ 0
struct ClipPlaneRow {
  const char* name;  ///< "in front", "behind", "left", "right", "below", "above"
  int axis;          ///< the coordinate that is set on this plane: 0 x, 1 y, 2 z
  double bound;      ///< its value on the plane as a multiple of w: -1, 0 or 1
  double sign;       ///< signed value = sign · (coordinate - bound·w)
};

inline constexpr std::array<ClipPlaneRow, clip_plane_count> clip_planes{{
    {"in front", 2, 0.0, 1.0},
    {"behind", 2, 1.0, -1.0},
    {"left", 0, -1.0, 1.0},
    {"right", 0, 1.0, -1.0},
    {"below", 1, -1.0, 1.0},
    {"above", 1, 1.0, -1.0},
}};

using Outcode = std::uint8_t;

/// sign · (coordinate - bound·w): ≥ 0 inside.
constexpr double signed_value(const ClipPlaneRow& plane, const glm::dvec4& v) {
  return plane.sign * (v[plane.axis] - plane.bound * v.w);
}

/// The 6-bit outcode of a homogeneous point; NaN counts as outside.
constexpr Outcode outcode(const glm::dvec4& v) {
  unsigned code = 0;
  for (int i = 0; i < clip_plane_count; ++i) {
    if (!(signed_value(clip_planes[static_cast<unsigned>(i)], v) >= 0.0)) code |= 1u << i;
  }
  return static_cast<Outcode>(code);
}

}  // namespace velum
