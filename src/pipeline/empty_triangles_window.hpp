#pragma once

#include <cstdint>

#include "geometry_kernels.hpp"

namespace velum {

/// Vertices that stand so near to each other that their distances from a corner of their box fit 16 bits.
struct PlacedWindow {
  std::int32_t left = 0, top = 0;  ///< 1/256 pixel, multiples of 256: the corner
  bool is_narrow = false;          ///< false as well if a vertex has no place on the picture
};

/// Farther apart than this, less the pixel that the corner is rounded by, vertices are not narrow: 1/256
/// pixel. Half a pixel more still fits.
inline constexpr std::int32_t window_size = 126 * 256;

/// Of so many vertices at most.
inline constexpr std::uint32_t most_packed_vertices = 65536;

/// Around vertices.
struct PlacedBox {
  std::int32_t left = INT32_MAX, top = INT32_MAX, right = INT32_MIN, bottom = INT32_MIN;

  void include(const PlacedVertex& v) {
    left = v.x < left ? v.x : left;
    right = v.x > right ? v.x : right;
    top = v.y < top ? v.y : top;
    bottom = v.y > bottom ? v.y : bottom;
  }
};

inline PlacedWindow window_around(const PlacedBox& box) {
  if (box.left == not_snapped || box.left > box.right) return {};
  const std::int32_t left = box.left & -256, top = box.top & -256;
  return {left, top, box.right - left < window_size && box.bottom - top < window_size};
}

}  // namespace velum
