#include "tile_bins.hpp"

#include <algorithm>
#include <numeric>

namespace velum {
namespace {

/// Pixels first … last along one axis.
struct Span {
  int first;
  int last;
};

/// The pixels of the target whose centres lie between the smallest and the largest coordinate.
Span centres_between(std::int32_t a, std::int32_t b, std::int32_t c, int begin, int end) {
  constexpr std::int32_t half = subpixels / 2;
  const std::int32_t lowest = std::min({a, b, c});
  const std::int32_t highest = std::max({a, b, c});
  return {std::max((lowest + half - 1) >> subpixel_bits, begin),
          std::min((highest - half) >> subpixel_bits, end - 1)};
}

TileRange tiles_of(const RasterTriangle& t, const TileGrid& grid) {
  const Rect& target = grid.target;
  const Span x = centres_between(t.x[0], t.x[1], t.x[2], target.left, target.right());
  const Span y = centres_between(t.y[0], t.y[1], t.y[2], target.top, target.bottom());
  const auto tile = [](int pixel) { return static_cast<std::uint16_t>(pixel / tile_size); };
  return {tile(x.first - target.left), tile(y.first - target.top), tile(x.last - target.left),
          tile(y.last - target.top)};
}

/// Calls visit(tile) for every tile of the range.
template <typename Visit>
void for_each_tile(const TileRange& range, const TileGrid& grid, const Visit& visit) {
  for (int row = range.top; row <= range.bottom; ++row) {
    for (int column = range.left; column <= range.right; ++column) {
      visit(static_cast<std::size_t>(row * grid.columns + column));
    }
  }
}

}  // namespace

void TileBins::clear() {
  triangles.clear();
  ranges.clear();
  first_entry.clear();
  entries.clear();
}

bool append_triangle(const ScreenTriangle& triangle, const Rect& target, TileBins& bins) {
  const std::int64_t area = doubled_area(triangle.vertices);
  if (area == 0) return false;
  const SnappedVertex& a = triangle.vertices[0];
  const SnappedVertex& b = triangle.vertices[area < 0 ? 2 : 1];
  const SnappedVertex& c = triangle.vertices[area < 0 ? 1 : 2];
  const Span x = centres_between(a.x, b.x, c.x, target.left, target.right());
  const Span y = centres_between(a.y, b.y, c.y, target.top, target.bottom());
  if (x.first > x.last || y.first > y.last) return true;
  const DepthPlane& depth = triangle.depth;
  bins.triangles.push_back({{a.x, b.x, c.x},
                            {a.y, b.y, c.y},
                            depth.r_ref,
                            depth.dx,
                            depth.dy,
                            depth.x_ref,
                            depth.y_ref,
                            depth.lower,
                            depth.upper,
                            triangle.primitive});
  return true;
}

namespace {

/// Fills bins.ranges. @return how many entries they make
std::uint64_t find_ranges(const TileGrid& grid, TileBins& bins) {
  std::uint64_t entries = 0;
  bins.ranges.clear();
  for (const RasterTriangle& triangle : bins.triangles) {
    const TileRange range = tiles_of(triangle, grid);
    entries += static_cast<std::uint64_t>(range.right - range.left + 1) *
               static_cast<std::uint64_t>(range.bottom - range.top + 1);
    bins.ranges.push_back(range);
  }
  return entries;
}

}  // namespace

void sort_into_tiles(const TileGrid& grid, TileBins& bins) {
  const std::uint64_t entries = find_ranges(grid, bins);
  if (entries > most_tile_entries) {
    bins.first_entry.clear();
    bins.entries.resize(bins.triangles.size());
    std::iota(bins.entries.begin(), bins.entries.end(), 0u);
    return;
  }
  bins.first_entry.assign(static_cast<std::size_t>(grid.count()) + 1, 0);
  for (const TileRange& range : bins.ranges) {
    for_each_tile(range, grid, [&](std::size_t tile) { ++bins.first_entry[tile + 1]; });
  }
  for (std::size_t i = 1; i < bins.first_entry.size(); ++i) bins.first_entry[i] += bins.first_entry[i - 1];
  bins.entries.resize(static_cast<std::size_t>(entries));
  // Each tile's beginning moves to its end while entries come in; then all move back by one.
  for (std::uint32_t i = 0; i < bins.triangles.size(); ++i) {
    for_each_tile(bins.ranges[i], grid,
                  [&](std::size_t tile) { bins.entries[bins.first_entry[tile]++] = i; });
  }
  std::copy_backward(bins.first_entry.begin(), bins.first_entry.end() - 1, bins.first_entry.end());
  bins.first_entry.front() = 0;
}

}  // namespace velum
