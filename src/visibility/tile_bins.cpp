#include "tile_bins.hpp"

#include <algorithm>
#include <numeric>

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

TileRange tiles_of(const SmallTriangle& t, const TileGrid& grid) {
  return tiles_of(t.left, t.top, t.right, t.bottom, grid);
}

TileRange tiles_of(const RasterTriangle& t, const TileGrid& grid) {
  constexpr std::int32_t half = subpixels / 2;
  const Rect& target = grid.target;
  const auto [x_min, x_max] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [y_min, y_max] = std::minmax({t.y[0], t.y[1], t.y[2]});
  return tiles_of(std::max((x_min + half - 1) >> subpixel_bits, target.left),
                  std::max((y_min + half - 1) >> subpixel_bits, target.top),
                  std::min((x_max - half) >> subpixel_bits, target.right() - 1),
                  std::min((y_max - half) >> subpixel_bits, target.bottom() - 1), grid);
}

/// Calls visit(tile) for every tile of the range.
template <typename Visit>
void for_each_tile(const TileRange& range, const TileGrid& grid, const Visit& visit) {
  for (int row = range.top; row <= range.bottom; ++row) {
    for (int column = range.left; column <= range.right; ++column) visit(row * grid.columns + column);
  }
}

/// Whether sorting them would make too many entries.
bool meet_too_many_tiles(const ScreenPrimitives& primitives, const TileGrid& grid) {
  std::uint64_t entries = 0;
  for (std::size_t i = 0; i < primitives.large_count; ++i) {
    entries += static_cast<std::uint64_t>(tiles_of(primitives.large[i], grid).count());
  }
  return entries > most_tile_entries;
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
  large_are_sorted_ = !meet_too_many_tiles(primitives, grid);
  for (std::size_t i = 0; large_are_sorted_ && i < primitives.large_count; ++i) {
    for_each_tile(tiles_of(primitives.large[i], grid), grid, [&](int tile) { ++next[tile].large; });
  }
  for (std::size_t i = 0; i < primitives.small_count; ++i) {
    for_each_tile(tiles_of(primitives.small[i], grid), grid, [&](int tile) { ++next[tile].small; });
  }
  for (std::size_t i = 0; i < primitives.fragment_count; ++i) {
    ++next[primitives.fragments[i].place / tile_pixels].fragment;
  }
  for (std::size_t i = 2; i < tiles + 2; ++i) {
    first[i].large += first[i - 1].large;
    first[i].small += first[i - 1].small;
    first[i].fragment += first[i - 1].fragment;
  }
}

// While primitives come in, first_[tile + 1] moves from the tile's beginning to its end.

void TileBins::place_large(const ScreenPrimitives& primitives, const TileGrid& grid) {
  const auto count = static_cast<std::uint32_t>(primitives.large_count);
  First* const next = first_.data() + 1 - first_tile_;
  std::uint32_t* const large = large_.make_room(large_are_sorted_ ? next[end_tile_].large : count);
  if (!large_are_sorted_) return std::iota(large, large + count, 0u);
  for (std::uint32_t i = 0; i < count; ++i) {
    for_each_tile(tiles_of(primitives.large[i], grid), grid,
                  [&](int tile) { large[next[tile].large++] = i; });
  }
}

void TileBins::place_small(const ScreenPrimitives& primitives, const TileGrid& grid) {
  First* const next = first_.data() + 1 - first_tile_;
  std::uint32_t* const small = small_.make_room(next[end_tile_].small);
  for (std::uint32_t i = 0; i < primitives.small_count; ++i) {
    for_each_tile(tiles_of(primitives.small[i], grid), grid,
                  [&](int tile) { small[next[tile].small++] = i; });
  }
}

void TileBins::place_fragments(const ScreenPrimitives& primitives) {
  First* const next = first_.data() + 1 - first_tile_;
  RasterFragment* const fragments = fragments_.make_room(primitives.fragment_count);
  for (std::size_t i = 0; i < primitives.fragment_count; ++i) {
    const RasterFragment& fragment = primitives.fragments[i];
    fragments[next[fragment.place / tile_pixels].fragment++] = fragment;
  }
}

void TileBins::sort(const ScreenPrimitives& primitives, const TileGrid& grid) {
  primitives_ = &primitives;
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
  work.large = primitives_->large.data();
  work.large_indices = large_.data() + (large_are_sorted_ ? first.large : 0);
  work.large_count = large_are_sorted_ ? end.large - first.large : primitives_->large_count;
  work.small = primitives_->small.data();
  work.small_indices = small_.data() + first.small;
  work.small_count = end.small - first.small;
  work.fragments = fragments_.data() + first.fragment;
  work.fragment_count = end.fragment - first.fragment;
  return work;
}

}  // namespace velum
