#pragma once

#include <cstdint>

namespace velum {

/// The production z-buffer works on squares of tile_size pixels that stay in the nearest caches.
inline constexpr int tile_size = 64;
/// A tile is made of squares of block_size pixels whose farthest depth is known.
inline constexpr int block_size = 8;
inline constexpr int block_pixels = block_size * block_size;
inline constexpr int blocks_per_tile = tile_size / block_size;
/// Its pixels stand in columns of block_size, each from top to bottom: a block's pixels follow one another,
/// so do the rows of a small triangle, and vectors begin at a multiple of their size.
/// A cache line more sets the columns apart: without it the pixels of a row would all compete for the same
/// places of the first cache.
inline constexpr int column_room = block_size * tile_size + 16;
inline constexpr int tile_room = blocks_per_tile * column_room;

/// Where pixel (x, y) of a tile stands in it.
constexpr int tile_place(int x, int y) {
  return x / block_size * column_room + y * block_size + x % block_size;
}

/// A tile of the visibility buffer while it is drawn. Pixels outside the picture hold +infinity: nothing is
/// ever nearer.
struct TileBuffer {
  /// Bits of the reversed depth. It is never negative, so they compare as integers.
  alignas(64) std::int32_t depth[tile_room];
  /// Primitive ids with the top bit turned over: compared as signed integers they have their order.
  alignas(64) std::int32_t primitive[tile_room];
  /// Per block, row after row of them, a lower bound of the reversed depths in it; what lies behind is
  /// hidden.
  alignas(64) float farthest[blocks_per_tile * blocks_per_tile];
  /// Blocks that small triangles have been drawn in since `farthest` was last looked after, a bit each
  /// in the order of `farthest`.
  std::uint64_t touched = 0;
  int width = tile_size;  ///< of the part that lies in the picture, from the top left corner
  int height = tile_size;
  /// A lower bound of all depths that the tile will have when everything known is drawn.
  float occluder = 0.0f;
  bool has_occluder = false;  ///< whether `occluder` or any of `farthest` is above 0
};

}  // namespace velum
