#pragma once

#include <cstdint>

namespace velum {

/// The production z-buffer works on squares of tile_size pixels that stay in the nearest caches.
inline constexpr int tile_size = 64;
/// Side of the blocks within a tile whose farthest depth is known.
inline constexpr int block_size = 8;
inline constexpr int blocks_per_tile = tile_size / block_size;
/// Elements from row to row: a vector that begins inside the tile may run over its right edge.
inline constexpr int tile_stride = tile_size + block_size;

/// A tile of the visibility buffer while it is drawn. Pixels outside the picture hold +infinity: nothing is
/// ever nearer.
struct TileBuffer {
  /// Bits of the reversed depth. It is never negative, so they compare as integers.
  alignas(64) std::int32_t depth[tile_size * tile_stride];
  /// Primitive ids with the top bit turned over: compared as signed integers they have their order.
  alignas(64) std::int32_t primitive[tile_size * tile_stride];
  /// Per block a lower bound of the reversed depths in it; what lies behind is hidden.
  alignas(64) float farthest[blocks_per_tile * blocks_per_tile];
  bool has_occluder = false;  ///< whether any of `farthest` is above 0
};

}  // namespace velum
