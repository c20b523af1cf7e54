#pragma once

#include <cstdint>

#include "../base/rect.hpp"
#include "tile_buffer.hpp"

namespace velum {

/// The tiles that cover the part of the picture being rendered, row by row from its top left corner.
struct TileGrid {
  Rect target;
  int columns = 0;
  int rows = 0;

  explicit TileGrid(const Rect& rect)
      : target(rect),
        columns((rect.width + tile_size - 1) / tile_size),
        rows((rect.height + tile_size - 1) / tile_size) {}
  int count() const { return columns * rows; }
  int left(int tile) const { return target.left + tile % columns * tile_size; }
  int top(int tile) const { return target.top + tile / columns * tile_size; }
  /// The tile of a pixel of the picture. @pre the pixel lies in the target
  int at(int x, int y) const {
    return (y - target.top) / tile_size * columns + (x - target.left) / tile_size;
  }
};

/// Pixels left … right of rows top … bottom, ends included; to begin with, none.
struct PixelBox {
  std::int32_t left = INT32_MAX, top = INT32_MAX, right = INT32_MIN, bottom = INT32_MIN;

  bool is_empty() const { return left > right || top > bottom; }
};

/// The smallest box around both.
constexpr PixelBox united(const PixelBox& a, const PixelBox& b) {
  return {a.left < b.left ? a.left : b.left, a.top < b.top ? a.top : b.top,
          a.right > b.right ? a.right : b.right, a.bottom > b.bottom ? a.bottom : b.bottom};
}

}  // namespace velum
