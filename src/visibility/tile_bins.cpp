#include "tile_bins.hpp"

#include <algorithm>

namespace velum {
namespace {

/// The tiles that a box of pixels meets: columns left … right of rows top … bottom.
struct TileRange {
  int left, top, right, bottom;

  int count() const { return (right - left + 1) * (bottom - top + 1); }
};

TileRange tiles_of(int left, int top, int right, int bottom, const TileGrid& grid) {
  const auto column = [&](int x) {
    return static_cast<int>(static_cast<unsigned>(x - grid.target.left) / tile_size);
  };
  const auto row = [&](int y) {
    return static_cast<int>(static_cast<unsigned>(y - grid.target.top) / tile_size);
  };
  return {column(left), row(top), column(right), row(bottom)};
}

TileRange tiles_of(const PixelBox& box, const TileGrid& grid) {
  return tiles_of(box.left, box.top, box.right, box.bottom, grid);
}

/// The largest reversed depth of the triangle's plane over a tile: it stands at a corner.
float nearest_in(const RasterTriangle& t, int left, int top) {
  const int x = (t.dx > 0.0f ? left + tile_size - 1 : left) - t.x_ref;
  const int y = (t.dy > 0.0f ? top + tile_size - 1 : top) - t.y_ref;
  const float r = (t.r_ref + t.dx * static_cast<float>(x)) + t.dy * static_cast<float>(y);
  return r < t.lower ? t.lower : (r > t.upper ? t.upper : r);
}

/// @param box  the triangle's centres_in_box()
LargeEntry large_entry(const RasterTriangle& t, const PixelBox& box, std::uint32_t index, int left, int top,
                       const Rect& target) {
  const bool may_occlude = box.left <= std::max(left, target.left) && box.top <= std::max(top, target.top) &&
                           box.right >= std::min(left + tile_size, target.right()) - 1 &&
                           box.bottom >= std::min(top + tile_size, target.bottom()) - 1;
  return {index, nearest_in(t, left, top), may_occlude};
}

/// Calls visit(column, row) for every tile of the range.
template <typename Visit>
void for_each_tile(const TileRange& range, const Visit& visit) {
  for (int row = range.top; row <= range.bottom; ++row) {
    for (int column = range.left; column <= range.right; ++column) visit(column, row);
  }
}

TileRange tiles_of(const SmallBounds& bounds) {
  return {bounds.left / blocks_per_tile, bounds.top / blocks_per_tile, bounds.right / blocks_per_tile,
          bounds.bottom / blocks_per_tile};
}

/// Those of a triangle's blocks that lie in a tile, one of several that it meets.
BlockBox blocks_in_tile(const SmallBounds& bounds, int column, int row) {
  const int x = column * blocks_per_tile, y = row * blocks_per_tile;
  const auto part = [](int block) {
    return static_cast<std::uint8_t>(std::clamp(block, 0, blocks_per_tile - 1));
  };
  return {part(bounds.left - x), part(bounds.top - y), part(bounds.right - x), part(bounds.bottom - y)};
}

/// The same where it meets one tile only.
BlockBox blocks_in_its_tile(const SmallBounds& bounds) {
  const auto part = [](unsigned block) { return static_cast<std::uint8_t>(block % blocks_per_tile); };
  return {part(bounds.left), part(bounds.top), part(bounds.right), part(bounds.bottom)};
}

/// Whether it meets one tile only.
bool is_in_one_tile(const SmallBounds& bounds) {
  return ((bounds.left ^ bounds.right) | (bounds.top ^ bounds.bottom)) < blocks_per_tile;
}

int tile_of(const SmallBounds& bounds, const TileGrid& grid) {
  return bounds.top / blocks_per_tile * grid.columns + bounds.left / blocks_per_tile;
}

}  // namespace

void TileBins::count(const ScreenPrimitives& primitives, const TileGrid& grid) {
  const PixelBox& box = primitives.box;
  first_tile_ = box.is_empty() ? 0 : grid.at(box.left, box.top);
  end_tile_ = box.is_empty() ? 0 : grid.at(box.right, box.bottom) + 1;
  const auto tiles = static_cast<std::size_t>(end_tile_ - first_tile_);
  // Counted one place ahead, so that summing up leaves each tile's beginning.
  First* const first = first_.make_room(tiles + 2);
  std::fill_n(first, tiles + 2, First{0, 0, 0});
  First* const next = first + 2 - first_tile_;
  count_large(primitives, grid, next);
  count_small(primitives, grid, next);
  for (std::size_t i = 0; i < primitives.fragment_count; ++i) {
    ++next[primitives.fragments.all().place[i] / fragment_places].fragment;
  }
  for (std::size_t i = 2; i < tiles + 2; ++i) {
    first[i].large += first[i - 1].large;
    first[i].small += first[i - 1].small;
    first[i].fragment += first[i - 1].fragment;
  }
}

void TileBins::count_large(const ScreenPrimitives& primitives, const TileGrid& grid, First* next) {
  PixelBox* const boxes = large_boxes_.make_room(primitives.large_count);
  std::uint64_t entries = 0;
  for (std::size_t i = 0; i < primitives.large_count; ++i) {
    boxes[i] = centres_in_box(primitives.large[i].x, primitives.large[i].y, grid.target);
    entries += static_cast<std::uint64_t>(tiles_of(boxes[i], grid).count());
  }
  large_are_sorted_ = entries <= most_tile_entries;
  for (std::size_t i = 0; large_are_sorted_ && i < primitives.large_count; ++i) {
    for_each_tile(tiles_of(boxes[i], grid),
                  [&](int column, int row) { ++next[row * grid.columns + column].large; });
  }
}

void TileBins::count_small(const ScreenPrimitives& primitives, const TileGrid& grid, First* next) {
  for (std::size_t i = 0; i < primitives.small_count; ++i) {
    const SmallBounds& bounds = primitives.small_bounds[i];
    if (is_in_one_tile(bounds)) {
      ++next[tile_of(bounds, grid)].small;
      continue;
    }
    for_each_tile(tiles_of(bounds), [&](int column, int row) { ++next[row * grid.columns + column].small; });
  }
}

// While primitives come in, first_[tile + 1] moves from the tile's beginning to its end.

void TileBins::place_large(const ScreenPrimitives& primitives, const TileGrid& grid) {
  const auto count = static_cast<std::uint32_t>(primitives.large_count);
  First* const next = first_.data() + 1 - first_tile_;
  LargeEntry* const large = large_.make_room(large_are_sorted_ ? next[end_tile_].large : count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const RasterTriangle& triangle = primitives.large[i];
    if (!large_are_sorted_) {
      large[i] = {i, triangle.upper, true};
      continue;
    }
    const PixelBox& box = large_boxes_[i];
    for_each_tile(tiles_of(box, grid), [&](int column, int row) {
      const int tile = row * grid.columns + column;
      large[next[tile].large++] = large_entry(triangle, box, i, grid.left(tile), grid.top(tile), grid.target);
    });
  }
}

void TileBins::place_small(const ScreenPrimitives& primitives, const TileGrid& grid) {
  First* const next = first_.data() + 1 - first_tile_;
  SmallEntry* const small = small_.make_room(next[end_tile_].small);
  const SmallBounds* const bounds_of = primitives.small_bounds.data();
  const std::uint32_t* const refs = primitives.small_refs.data();
  for (std::size_t i = 0; i < primitives.small_count; ++i) {
    const SmallBounds& bounds = bounds_of[i];
    if (is_in_one_tile(bounds)) {
      SmallEntry& entry = small[next[tile_of(bounds, grid)].small++];
      entry.ref = refs[i];
      entry.nearest = bounds.nearest;
      entry.blocks = blocks_in_its_tile(bounds);
      continue;
    }
    for_each_tile(tiles_of(bounds), [&](int column, int row) {
      small[next[row * grid.columns + column].small++] = {refs[i], bounds.nearest,
                                                          blocks_in_tile(bounds, column, row)};
    });
  }
}

void TileBins::place_fragments(const ScreenPrimitives& primitives) {
  First* const next = first_.data() + 1 - first_tile_;
  RasterFragment* const fragments = fragments_.make_room(primitives.fragment_count);
  const ConstFragmentArrays all = primitives.fragments.all();
  for (std::size_t i = 0; i < primitives.fragment_count; ++i) {
    // Field by field: a fragment put together first would have to wait for its own words.
    RasterFragment& fragment = fragments[next[all.place[i] / fragment_places].fragment++];
    fragment.place = all.place[i];
    fragment.depth = all.depth[i];
    fragment.primitive = all.primitive[i];
  }
}

void TileBins::sort(const ScreenPrimitives& primitives, const TileGrid& grid) {
  large_triangles_ = primitives.large.data();
  small_triangles_ = primitives.small.data();
  small_sources_ = primitives.sources.data();
  small_source_count_ = primitives.sources.size();
  large_count_ = primitives.large_count;
  count(primitives, grid);
  if (end_tile_ == first_tile_) return;
  place_large(primitives, grid);
  place_small(primitives, grid);
  place_fragments(primitives);
}

TilePrimitives TileBins::of_tile(int tile) const {
  if (tile < first_tile_ || tile >= end_tile_) return {};
  const First& first = first_[static_cast<std::size_t>(tile - first_tile_)];
  const First& end = first_[static_cast<std::size_t>(tile - first_tile_) + 1];
  TilePrimitives work{};
  work.large = large_triangles_;
  work.large_entries = large_.data() + (large_are_sorted_ ? first.large : 0);
  work.large_count = large_are_sorted_ ? end.large - first.large : large_count_;
  work.small = small_triangles_;
  work.small_sources = small_sources_;
  work.small_source_count = small_source_count_;
  work.small_entries = small_.data() + first.small;
  work.small_count = end.small - first.small;
  work.fragments = fragments_.data() + first.fragment;
  work.fragment_count = end.fragment - first.fragment;
  return work;
}

}  // namespace velum
