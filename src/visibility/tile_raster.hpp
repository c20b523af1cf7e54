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

/// The triangles of one tile.
struct TileTriangles {
  const RasterTriangle* triangles;
  const std::uint32_t* indices;  ///< those that meet the tile
  std::size_t count;
};

/// Draws triangles into a tile: coverage by integer edge functions (Pineda 1988), eight pixels at a time;
/// larger triangles block by block, blocks wholly outside, or wholly behind what the block shows, left out
/// (Greene 1996; McCormack & McNamara 2000). What it leaves in the tile is what rasterize_zbuffer leaves in
/// the visibility buffer, to the bit.
/// @param left, top  the tile's first pixel in the picture
/// @pre coordinates are within ±2²³
using RasterizeTile = void (*)(const TileTriangles& work, int left, int top, TileBuffer& tile,
                               TileCounts& counts);

/// The kernel for an instruction set. @pre is_available(isa), and not `reference`
RasterizeTile tile_raster(Isa isa);

}  // namespace velum
