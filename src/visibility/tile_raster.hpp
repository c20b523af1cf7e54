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

/// What meets a tile. Triangles stand anywhere, the indices tell which.
struct TilePrimitives {
  const RasterTriangle* large;
  const std::uint32_t* large_indices;
  std::size_t large_count;
  const SmallTriangle* small;
  const std::uint32_t* small_indices;
  std::size_t small_count;
  const RasterFragment* fragments;
  std::size_t fragment_count;

  bool is_empty() const { return large_count + small_count + fragment_count == 0; }
};

/// The kernels of the tile raster. Coverage comes from integer edge functions (Pineda 1988), as many pixels
/// at a time as a vector holds; larger triangles go block by block, blocks wholly outside, or wholly behind
/// what the block shows, left out (Greene 1996; McCormack & McNamara 2000). What they leave in the tile is
/// what rasterize_zbuffer leaves in the visibility buffer, to the bit, in whichever order they are called.
struct TileRaster {
  /// Draws primitives. @param left, top  the tile's first pixel in the picture
  /// @pre coordinates are within ±2²³
  using Draw = void (*)(const TilePrimitives& work, int left, int top, TileBuffer& tile, TileCounts& counts);
  /// Looks for a large triangle that covers the whole tile: what lies behind it will be hidden, and need not
  /// be drawn even where it comes first. Raises tile.occluder.
  using FindOccluder = void (*)(const TilePrimitives& work, int left, int top, TileBuffer& tile);

  Draw draw;
  FindOccluder find_occluder;
};

/// The kernels for an instruction set. @pre is_available(isa), and not `reference`
TileRaster tile_raster(Isa isa);

}  // namespace velum
