#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "../base/rect.hpp"
#include "raster_target.hpp"
#include "raster_triangle.hpp"
#include "screen_triangle.hpp"
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
};

/// The tiles that a triangle's box meets: columns left … right of rows top … bottom.
struct TileRange {
  std::uint16_t left, top, right, bottom;
};

/// The most entries that triangles are sorted into: 16 MB. Beyond that (thousands of triangles, each over
/// hundreds of tiles) every tile gets all of them and its raster leaves out those that do not meet it.
inline constexpr std::uint64_t most_tile_entries = std::uint64_t{1} << 22;

/// Screen triangles sorted by the tiles they meet; the memory is kept from use to use.
struct TileBins {
  std::vector<RasterTriangle> triangles;
  std::vector<TileRange> ranges;           ///< of the triangles
  std::vector<std::uint32_t> first_entry;  ///< of each tile; one more at the end. Empty: all for every tile
  std::vector<std::uint32_t> entries;      ///< indices of triangles, tile after tile, in their order

  void clear();
  std::span<const std::uint32_t> of_tile(int tile) const {
    if (first_entry.empty()) return entries;
    const auto i = static_cast<std::size_t>(tile);
    return std::span(entries).subspan(first_entry[i], first_entry[i + 1] - first_entry[i]);
  }
};

/// Appends the triangle, turned clockwise, if a pixel centre of the target lies in its box.
/// @return false if it has no area on the pixel grid
bool append_triangle(const ScreenTriangle& triangle, const Rect& target, TileBins& bins);

/// Fills first_entry and entries from the triangles, by counting.
void sort_into_tiles(const TileGrid& grid, TileBins& bins);

}  // namespace velum
