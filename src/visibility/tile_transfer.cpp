#include "tile_transfer.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace velum {
namespace {

constexpr std::uint32_t order_bit = 0x80000000u;

std::int32_t bits_of(float depth) {
  return std::bit_cast<std::int32_t>(depth);
}
std::int32_t ordered(std::uint32_t id) {
  return static_cast<std::int32_t>(id ^ order_bit);
}

/// The tile's part in the target, in pixels of the target's buffer. Sets the tile's size; nothing is touched.
Rect part_of(const Rect& target, int left, int top, TileBuffer& tile) {
  const Rect part = intersect(Rect{left, top, tile_size, tile_size}, target);
  tile.width = part.width;
  tile.height = part.height;
  tile.touched = 0;
  return {part.left - target.left, part.top - target.top, part.width, part.height};
}

/// Fills everything; what lies outside the picture with depths that nothing is nearer than.
void fill(TileBuffer& tile, std::int32_t depth, std::int32_t primitive) {
  std::fill_n(tile.depth, tile_room, depth);
  std::fill_n(tile.primitive, tile_room, primitive);
}
constexpr std::int32_t nearest_of_all = 0x7f800000;  // +infinity

/// Calls visit(place, x, y, count) for every run of pixels that stand together both in the tile and in a row.
template <typename Visit>
void for_each_run(int width, int height, const Visit& visit) {
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; x += block_size)
      visit(tile_place(x, y), x, y, std::min(block_size, width - x));
  }
}

void find_farthest(TileBuffer& tile) {
  tile.has_occluder = false;
  tile.occluder = 0.0f;
  for (int block = 0; block < blocks_per_tile * blocks_per_tile; ++block) {
    const int left = block % blocks_per_tile * block_size, top = block / blocks_per_tile * block_size;
    const std::int32_t* depth = tile.depth + tile_place(left, top);
    std::int32_t farthest = nearest_of_all;
    for (int i = 0; i < block_pixels; ++i) farthest = std::min(farthest, depth[i]);
    tile.farthest[block] = std::bit_cast<float>(farthest);
    tile.has_occluder = tile.has_occluder || farthest > 0;
  }
}

}  // namespace

void load_tile(const VisibilityBuffer& buffer, const Rect& target, int left, int top, TileBuffer& tile) {
  const Rect part = part_of(target, left, top, tile);
  if (part.width != tile_size || part.height != tile_size) fill(tile, nearest_of_all, ordered(0));
  for_each_run(part.width, part.height, [&](int place, int x, int y, int count) {
    const float* depth = buffer.reversed_depth.row(part.top + y) + part.left + x;
    const std::uint32_t* id = buffer.primitive.row(part.top + y) + part.left + x;
    for (int i = 0; i < count; ++i) tile.depth[place + i] = bits_of(depth[i]);
    for (int i = 0; i < count; ++i) tile.primitive[place + i] = ordered(id[i]);
  });
  find_farthest(tile);
}

void clear_tile(const Rect& target, int left, int top, TileBuffer& tile) {
  const Rect part = part_of(target, left, top, tile);
  const bool is_whole = part.width == tile_size && part.height == tile_size;
  if (is_whole) {
    fill(tile, bits_of(0.0f), ordered(no_primitive));
    std::fill_n(tile.farthest, blocks_per_tile * blocks_per_tile, 0.0f);
    tile.has_occluder = false;
    tile.occluder = 0.0f;
    return;
  }
  fill(tile, nearest_of_all, ordered(0));
  for_each_run(part.width, part.height, [&](int place, int, int, int count) {
    std::fill_n(tile.depth + place, count, bits_of(0.0f));
    std::fill_n(tile.primitive + place, count, ordered(no_primitive));
  });
  find_farthest(tile);
}

namespace {

void store_run(const TileBuffer& tile, int place, int count, float* depth, std::uint32_t* id) {
  for (int i = 0; i < count; ++i) depth[i] = std::bit_cast<float>(tile.depth[place + i]);
  for (int i = 0; i < count; ++i) id[i] = static_cast<std::uint32_t>(tile.primitive[place + i]) ^ order_bit;
}

}  // namespace

void store_tile(const TileBuffer& tile, const Rect& target, int left, int top, VisibilityBuffer& buffer) {
  for_each_run(tile.width, tile.height, [&](int place, int x, int y, int count) {
    float* depth = buffer.reversed_depth.row(top - target.top + y) + (left - target.left) + x;
    std::uint32_t* id = buffer.primitive.row(top - target.top + y) + (left - target.left) + x;
    // A constant length is what compilers make vectors of.
    if (count == block_size) {
      store_run(tile, place, block_size, depth, id);
    } else {
      store_run(tile, place, count, depth, id);
    }
  });
}

}  // namespace velum
