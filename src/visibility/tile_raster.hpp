#pragma once

#include <cstddef>
#include <cstdint>

#include "../base/isa.hpp"
#include "raster_triangle.hpp"
#include "tile_buffer.hpp"

namespace velum {

/// What drawing into a tile did.
struct TileCounts {
  std::uint64_t hidden_triangles = 0;  ///< not drawn in the tile: behind all that stands there
  std::uint64_t hidden_blocks = 0;     ///< blocks of larger triangles left out for the same reason
  std::uint64_t drawn_blocks = 0;      ///< blocks of larger triangles that were looked at pixel by pixel
};

/// Blocks of a tile: columns first_column … last_column of rows first_row … last_row.
struct BlockBox {
  std::uint8_t first_column, first_row, last_column, last_row;
};

/// Sets up small triangles when they are about to be drawn. Many are hidden by then and never set up.
struct SmallSource {
  /// @param triangles  their numbers, counted from `first` on
  /// @param out        room for `count`
  using SetUp = void (*)(const void* work, const std::uint32_t* triangles, std::size_t count,
                         SmallTriangle* out);
  SetUp set_up;
  const void* work;          ///< what it is told
  std::uint32_t first, end;  ///< its triangles have the numbers first … end-1
};

/// A small triangle that meets a tile, and what tells whether it is hidden there: such need not be fetched.
struct SmallEntry {
  std::uint32_t ref;  ///< see ready_small
  float nearest;      ///< SmallTriangle::upper
  BlockBox blocks;    ///< that its box meets
};

/// A large triangle that meets a tile.
struct LargeEntry {
  std::uint32_t index;
  float nearest;     ///< nothing of it is nearer in the tile
  bool may_occlude;  ///< its box contains the tile
};

/// What meets a tile. Triangles stand anywhere, the entries tell which.
struct TilePrimitives {
  const RasterTriangle* large;
  const LargeEntry* large_entries;
  std::size_t large_count;
  const SmallTriangle* small;        ///< those that are set up
  const SmallSource* small_sources;  ///< of the others; in the order of their numbers
  std::size_t small_source_count;
  const SmallEntry* small_entries;
  std::size_t small_count;
  const RasterFragment* fragments;
  std::size_t fragment_count;

  bool is_empty() const { return large_count + small_count + fragment_count == 0; }
};

/// A SmallEntry, and which of the parts it is of.
struct SmallInTile {
  std::uint32_t ref;
  std::uint32_t part;
  float nearest;
  BlockBox blocks;
};

/// A LargeEntry and its triangle.
struct LargeInTile {
  const RasterTriangle* triangle;
  float nearest;
};

/// The kernels of the tile raster. Coverage comes from integer edge functions (Pineda 1988), as many pixels
/// at a time as a vector holds; larger triangles go block by block, blocks wholly outside, or wholly behind
/// what the block shows, left out (Greene 1996; McCormack & McNamara 2000). What they leave in the tile is
/// what rasterize_zbuffer leaves in the visibility buffer, to the bit, in whichever order they are called.
struct TileRaster {
  /// @param left, top  the tile's first pixel in the picture
  /// @pre coordinates are within ±2²³
  using OfLarge = void (*)(const LargeInTile* triangles, std::size_t count, int left, int top,
                           TileBuffer& tile, TileCounts& counts);
  /// @param parts  what the triangles are of
  using OfSmall = void (*)(const SmallInTile* triangles, std::size_t count, const TilePrimitives* parts,
                           int left, int top, TileBuffer& tile, TileCounts& counts);
  using OfFragments = void (*)(const RasterFragment* fragments, std::size_t count, TileBuffer& tile);

  /// Looks for a large triangle that covers the whole tile: what lies behind it will be hidden, and need not
  /// be drawn even where it comes first. Raises tile.occluder.
  void (*find_occluder)(const TilePrimitives& work, int left, int top, TileBuffer& tile);
  OfLarge draw_large;
  OfSmall draw_small;
  /// Raises tile.farthest where small triangles have been drawn.
  void (*find_farthest)(TileBuffer& tile);
  OfFragments draw_fragments;
};

/// The kernels for an instruction set. @pre is_available(isa), and not `reference`
TileRaster tile_raster(Isa isa);

}  // namespace velum
