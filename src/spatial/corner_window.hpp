#pragma once

#include <cstddef>
#include <cstdint>

namespace velum {

/// Neighbouring triangles of a cluster mostly share their vertices. For every window_triangles of them,
/// counted from the cluster's first, the smallest of their corners is kept if all are less than
/// window_corners larger: their vertices then fit into few vectors, where they can be looked up by the lane.
inline constexpr std::size_t window_triangles = 16;
inline constexpr std::size_t window_corners = 32;
/// Where they are farther apart.
inline constexpr std::uint16_t no_window = 0xFFFF;

/// @param corners  the first, second and third corners of neighbouring triangles
/// @param count    how many, 1 … window_triangles
inline std::uint16_t window_of_corners(const std::uint16_t* const (&corners)[3], std::size_t count) {
  std::uint16_t lowest = 0xFFFF, highest = 0;
  for (const std::uint16_t* const corner : corners) {
    for (std::size_t i = 0; i < count; ++i) {
      lowest = corner[i] < lowest ? corner[i] : lowest;
      highest = corner[i] > highest ? corner[i] : highest;
    }
  }
  return highest - lowest < static_cast<int>(window_corners) ? lowest : no_window;
}

}  // namespace velum
