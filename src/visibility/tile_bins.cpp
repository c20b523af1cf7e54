#include "tile_bins.hpp"

#include <algorithm>

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

struct TileRange {
  int left, top, right, bottom;  ///< inclusive
};

TileRange tiles_of(const RasterTriangle& t, const TileGrid& grid) {
  const Rect& target = grid.target;
  const Span x = centres_between(t.x[0], t.x[1], t.x[2], target.left, target.right());
  const Span y = centres_between(t.y[0], t.y[1], t.y[2], target.top, target.bottom());
  return {(x.first - target.left) / tile_size, (y.first - target.top) / tile_size,
          (x.last - target.left) / tile_size, (y.last - target.top) / tile_size};
}

/// Calls visit(tile) for every tile that the triangle's box meets.
template <typename Visit>
void for_each_tile(const RasterTriangle& triangle, const TileGrid& grid, const Visit& visit) {
  const TileRange tiles = tiles_of(triangle, grid);
  for (int row = tiles.top; row <= tiles.bottom; ++row) {
    for (int column = tiles.left; column <= tiles.right; ++column) {
      visit(static_cast<std::size_t>(row * grid.columns + column));
    }
  }
}

}  // namespace

void TileBins::clear() {
  triangles.clear();
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

void sort_into_tiles(const TileGrid& grid, TileBins& bins) {
  bins.first_entry.assign(static_cast<std::size_t>(grid.count()) + 1, 0);
  for (const RasterTriangle& triangle : bins.triangles) {
    for_each_tile(triangle, grid, [&](std::size_t tile) { ++bins.first_entry[tile + 1]; });
  }
  for (std::size_t i = 1; i < bins.first_entry.size(); ++i) bins.first_entry[i] += bins.first_entry[i - 1];
  bins.entries.resize(bins.first_entry.back());
  // Each tile's beginning moves to its end while entries come in; then all move back by one.
  for (std::uint32_t i = 0; i < bins.triangles.size(); ++i) {
    for_each_tile(bins.triangles[i], grid,
                  [&](std::size_t tile) { bins.entries[bins.first_entry[tile]++] = i; });
  }
  std::copy_backward(bins.first_entry.begin(), bins.first_entry.end() - 1, bins.first_entry.end());
  bins.first_entry.front() = 0;
}

}  // namespace velum
