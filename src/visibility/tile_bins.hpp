#pragma once

#include <cstdint>

#include "screen_primitives.hpp"
#include "tile_grid.hpp"
#include "tile_raster.hpp"

namespace velum {

/// The most entries that large triangles are sorted into: 1 MB. Beyond that (thousands of triangles, each
/// over hundreds of tiles) every tile gets all of them and its raster leaves out those that do not meet it.
inline constexpr std::uint64_t most_tile_entries = std::uint64_t{1} << 18;

/// Screen primitives sorted by the tiles they meet; the memory is kept from use to use.
class TileBins {
 public:
  /// Sorts by counting, so that each tile has its primitives in their order.
  /// @param primitives  its arrays must stay as they are until the last call of of_tile()
  void sort(const ScreenPrimitives& primitives, const TileGrid& grid);

  /// The primitives that meet the tile. For the large ones: those, or all.
  TilePrimitives of_tile(int tile) const;

 private:
  /// Where a tile's primitives begin.
  struct First {
    std::uint32_t large, small, fragment;
  };

  void count(const ScreenPrimitives& primitives, const TileGrid& grid);
  void count_large(const ScreenPrimitives& primitives, const TileGrid& grid, First* next);
  void count_small(const ScreenPrimitives& primitives, const TileGrid& grid, First* next);
  void place_large(const ScreenPrimitives& primitives, const TileGrid& grid);
  void place_small(const ScreenPrimitives& primitives, const TileGrid& grid);
  void place_fragments(const ScreenPrimitives& primitives);

  const RasterTriangle* large_triangles_ = nullptr;
  const SmallTriangle* small_triangles_ = nullptr;
  const SmallSource* small_sources_ = nullptr;
  std::size_t small_source_count_ = 0;
  std::size_t large_count_ = 0;
  int first_tile_ = 0;  ///< tiles first_tile_ … end_tile_-1 may have something
  int end_tile_ = 0;
  bool large_are_sorted_ = true;
  KeptArray<PixelBox> large_boxes_;
  // All of these tile after tile.
  KeptArray<First> first_;  ///< of each of these tiles, and one more at the end
  KeptArray<LargeEntry> large_;
  KeptArray<SmallEntry> small_;
  KeptArray<RasterFragment> fragments_;
};

}  // namespace velum
