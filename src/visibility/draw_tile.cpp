#include "draw_tile.hpp"

namespace velum {
namespace {

/// A bucket should have at least about as many: its end costs a look at what was drawn.
constexpr std::size_t small_bucket = 32;
constexpr std::size_t large_bucket = 4;

void sort_large(std::span<const TilePrimitives> work, NearFirst<LargeInTile>& out) {
  std::size_t count = 0;
  for (const TilePrimitives& part : work) count += part.large_count;
  out.begin(count);
  for (const TilePrimitives& part : work) {
    for (std::size_t i = 0; i < part.large_count; ++i) {
      const LargeEntry& entry = part.large_entries[i];
      out.add({part.large + entry.index, entry.nearest});
    }
  }
  out.sort(large_bucket);
}

void sort_small(std::span<const TilePrimitives> work, NearFirst<SmallInTile>& out) {
  std::size_t count = 0;
  for (const TilePrimitives& part : work) count += part.small_count;
  out.begin(count);
  for (std::uint32_t number = 0; number < work.size(); ++number) {
    const TilePrimitives& part = work[number];
    for (std::size_t i = 0; i < part.small_count; ++i) {
      const SmallEntry& entry = part.small_entries[i];
      out.add({entry.ref, number, entry.nearest, entry.blocks});
    }
  }
  out.sort(small_bucket);
}

}  // namespace

void TileOrder::make_room_like(const TileOrder& other) {
  large.make_room(other.large.room());
  small.make_room(other.small.room());
}

void draw_tile(const TileRaster& raster, std::span<const TilePrimitives> work, int left, int top,
               TileOrder& order, TileBuffer& tile, TileCounts& counts) {
  for (const TilePrimitives& part : work) {
    if (part.large_count > 0) raster.find_occluder(part, left, top, tile);
  }
  sort_large(work, order.large);
  for (int k = 0; k < order.large.buckets(); ++k) {
    const std::span<const LargeInTile> triangles = order.large.bucket(k);
    raster.draw_large(triangles.data(), triangles.size(), left, top, tile, counts);
  }
  sort_small(work, order.small);
  for (int k = 0; k < order.small.buckets(); ++k) {
    const std::span<const SmallInTile> triangles = order.small.bucket(k);
    raster.draw_small(triangles.data(), triangles.size(), work.data(), left, top, tile, counts);
    if (k + 1 < order.small.buckets()) raster.find_farthest(tile);
  }
  for (const TilePrimitives& part : work) raster.draw_fragments(part.fragments, part.fragment_count, tile);
}

}  // namespace velum
