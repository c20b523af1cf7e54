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

Rect tile_rect(int left, int top) {
  return {left, top, tile_size, tile_size};
}

/// Fills everything with depths that nothing is nearer than.
void close_tile(TileBuffer& tile) {
  std::fill_n(tile.depth, tile_size * tile_stride, bits_of(std::numeric_limits<float>::infinity()));
  std::fill_n(tile.primitive, tile_size * tile_stride, ordered(0));
}

void find_farthest(TileBuffer& tile) {
  tile.has_occluder = false;
  for (int block = 0; block < blocks_per_tile * blocks_per_tile; ++block) {
    const int x = block % blocks_per_tile * block_size;
    const int y = block / blocks_per_tile * block_size;
    std::int32_t farthest = bits_of(std::numeric_limits<float>::infinity());
    for (int row = y; row < y + block_size; ++row) {
      const std::int32_t* depth = tile.depth + row * tile_stride + x;
      farthest = std::min(farthest, *std::min_element(depth, depth + block_size));
    }
    tile.farthest[block] = std::bit_cast<float>(farthest);
    tile.has_occluder = tile.has_occluder || farthest > 0;
  }
}

}  // namespace

void load_tile(const VisibilityBuffer& buffer, const Rect& target, int left, int top, TileBuffer& tile) {
  const Rect part = intersect(tile_rect(left, top), target);
  if (part.width != tile_size || part.height != tile_size) close_tile(tile);
  for (int y = part.top; y < part.bottom(); ++y) {
    const float* depth = buffer.reversed_depth.row(y - target.top) + (part.left - target.left);
    const std::uint32_t* id = buffer.primitive.row(y - target.top) + (part.left - target.left);
    const int at = (y - top) * tile_stride + (part.left - left);
    std::transform(depth, depth + part.width, tile.depth + at, bits_of);
    std::transform(id, id + part.width, tile.primitive + at, ordered);
  }
  find_farthest(tile);
}

void clear_tile(const Rect& target, int left, int top, TileBuffer& tile) {
  const Rect part = intersect(tile_rect(left, top), target);
  const bool is_whole = part.width == tile_size && part.height == tile_size;
  if (!is_whole) close_tile(tile);
  for (int y = part.top; y < part.bottom(); ++y) {
    const int at = (y - top) * tile_stride + (part.left - left);
    std::fill_n(tile.depth + at, part.width, bits_of(0.0f));
    std::fill_n(tile.primitive + at, part.width, ordered(no_primitive));
  }
  std::fill_n(tile.farthest, blocks_per_tile * blocks_per_tile, 0.0f);
  tile.has_occluder = false;
  if (!is_whole) find_farthest(tile);
}

void store_tile(const TileBuffer& tile, const Rect& target, int left, int top, VisibilityBuffer& buffer) {
  const Rect part = intersect(tile_rect(left, top), target);
  for (int y = part.top; y < part.bottom(); ++y) {
    float* depth = buffer.reversed_depth.row(y - target.top) + (part.left - target.left);
    std::uint32_t* id = buffer.primitive.row(y - target.top) + (part.left - target.left);
    const int at = (y - top) * tile_stride + (part.left - left);
    std::transform(tile.depth + at, tile.depth + at + part.width, depth,
                   [](std::int32_t bits) { return std::bit_cast<float>(bits); });
    std::transform(tile.primitive + at, tile.primitive + at + part.width, id,
                   [](std::int32_t value) { return static_cast<std::uint32_t>(value) ^ order_bit; });
  }
}

}  // namespace velum
