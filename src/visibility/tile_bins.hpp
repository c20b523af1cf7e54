#pragma once

#include <cstdint>
#include <span>

#include "screen_primitives.hpp"
#include "tile_grid.hpp"

namespace velum {

/// The most entries that large triangles are sorted into: 1 MB. Beyond that (thousands of triangles, each
/// over hundreds of tiles) every tile gets all of them and its raster leaves out those that do not meet it.
inline constexpr std::uint64_t most_tile_entries = std::uint64_t{1} << 18;

/// What is drawn into one tile.
struct TileWork {
  const RasterTriangle* large;  ///< those that `large_indices` tell of
  std::span<const std::uint32_t> large_indices;
  std::span<const SmallTriangle> small;
  std::span<const RasterFragment> fragments;

  bool is_empty() const { return large_indices.empty() && small.empty() && fragments.empty(); }
};

/// Screen primitives sorted by the tiles they meet; the memory is kept from use to use.
class TileBins {
 public:
  /// Sorts by counting, so that each tile has its primitives in their order.
  void sort(const ScreenPrimitives& primitives, const TileGrid& grid);

  /// The primitives that meet the tile. For the large ones: those, or all.
  TileWork of_tile(int tile) const;

 private:
  /// Where a tile's primitives begin.
  struct First {
    std::uint32_t large, small, fragment;
  };

  void count(const ScreenPrimitives& primitives, const TileGrid& grid);
  void place_large(const ScreenPrimitives& primitives, const TileGrid& grid);
  void place_small(const ScreenPrimitives& primitives, const TileGrid& grid);
  void place_fragments(const ScreenPrimitives& primitives);

  int first_tile_ = 0;  ///< tiles first_tile_ … end_tile_-1 may have something
  int end_tile_ = 0;
  bool large_are_sorted_ = true;
  std::uint32_t large_count_ = 0;
  KeptArray<First> first_;  ///< of each of these tiles, and one more at the end
  KeptArray<RasterTriangle> large_;
  KeptArray<std::uint32_t> large_indices_;  ///< tile after tile
  KeptArray<SmallTriangle> small_;          ///< tile after tile; repeated for every tile
  KeptArray<RasterFragment> fragments_;     ///< tile after tile
};

}  // namespace velum
