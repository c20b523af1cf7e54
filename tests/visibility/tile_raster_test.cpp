#include "visibility/draw_tile.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <memory>
#include <vector>

#include "random.hpp"
#include "visibility/tile_bins.hpp"
#include "visibility/tile_transfer.hpp"
#include "visibility/zbuffer.hpp"

using namespace velum;

namespace {

using Soup = std::vector<ScreenTriangle>;

ScreenPrimitives primitives_of(std::span<const ScreenTriangle> soup, const TileGrid& grid) {
  ScreenPrimitives primitives;
  primitives.make_room(soup.size());
  for (const ScreenTriangle& triangle : soup) append_triangle(triangle, grid, primitives);
  return primitives;
}

/// Draws through bins and tiles, in two halves so that tiles are loaded again.
VisibilityBuffer by_tiles(const Soup& soup, const Rect& rect, Isa isa, TileCounts& counts) {
  VisibilityBuffer buffer(rect.width, rect.height);
  const auto tile = std::make_unique<TileBuffer>();
  const TileGrid grid(rect);
  const TileRaster raster = tile_raster(isa);
  TileOrder order;
  const std::size_t half = soup.size() / 2;
  for (const auto& part : {std::span(soup).first(half), std::span(soup).subspan(half)}) {
    TileBins bins;
    const ScreenPrimitives primitives = primitives_of(part, grid);
    bins.sort(primitives, grid);
    for (int i = 0; i < grid.count(); ++i) {
      const TilePrimitives work = bins.of_tile(i);
      load_tile(buffer, rect, grid.left(i), grid.top(i), *tile);
      draw_tile(raster, {&work, 1}, grid.left(i), grid.top(i), order, *tile, counts);
      store_tile(*tile, rect, grid.left(i), grid.top(i), buffer);
    }
  }
  return buffer;
}

/// The number of pixels whose bits differ.
int differences(const VisibilityBuffer& a, const VisibilityBuffer& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      count += std::bit_cast<std::uint32_t>(a.reversed_depth.at(x, y)) !=
                   std::bit_cast<std::uint32_t>(b.reversed_depth.at(x, y)) ||
               a.primitive.at(x, y) != b.primitive.at(x, y);
    }
  }
  return count;
}

/// Every instruction set of this machine against the reference.
TileCounts check_identity(const Soup& soup, const Rect& rect) {
  VisibilityBuffer expected(rect.width, rect.height);
  rasterize_zbuffer(soup, {expected, rect});
  TileCounts first;
  for (const Isa isa : available_isas()) {
    if (isa == Isa::reference) continue;
    CAPTURE(name_of(isa));
    TileCounts counts;
    CHECK(differences(by_tiles(soup, rect, isa, counts), expected) == 0);
    if (isa == Isa::emulated) first = counts;
    CHECK(counts.hidden_triangles == first.hidden_triangles);
    CHECK(counts.hidden_blocks == first.hidden_blocks);
    CHECK(counts.drawn_blocks == first.drawn_blocks);
  }
  return first;
}

/// A depth plane over the triangle: few distinct values, so that ties are frequent, or any.
DepthPlane random_plane(Random& random, int width, int height) {
  DepthPlane plane;
  plane.x_ref = random.below(width);
  plane.y_ref = random.below(height);
  plane.lower = 0.0f;
  plane.upper = 1.0f;
  if (random.below(2) == 0) {
    plane.r_ref = static_cast<float>(random.below(4)) * 0.25f;
    plane.lower = plane.upper = plane.r_ref;
    return plane;
  }
  plane.r_ref = static_cast<float>(random.uniform(0.0, 1.0));
  plane.dx = static_cast<float>(random.uniform(-1.0, 1.0) * 0.01);
  plane.dy = static_cast<float>(random.uniform(-1.0, 1.0) * 0.01);
  plane.lower = static_cast<float>(random.uniform(0.0, 0.3));
  plane.upper = static_cast<float>(random.uniform(0.6, 1.0));
  return plane;
}

/// Triangles of a given size in pixels; the ids fall, so that later ones win ties.
Soup random_soup(Random& random, int count, double size, int width, int height) {
  Soup soup;
  for (int i = 0; i < count; ++i) {
    ScreenTriangle triangle;
    const double x = random.uniform(-0.1, 1.1) * width;
    const double y = random.uniform(-0.1, 1.1) * height;
    const bool on_grid = random.below(4) == 0;
    for (SnappedVertex& v : triangle.vertices) {
      v.x = static_cast<std::int32_t>((x + random.uniform(-size, size)) * subpixels);
      v.y = static_cast<std::int32_t>((y + random.uniform(-size, size)) * subpixels);
      if (on_grid) v = {v.x & ~127, v.y & ~127};
    }
    triangle.depth = random_plane(random, width, height);
    triangle.primitive = i % 7 == 0 ? 0x80000000u - static_cast<std::uint32_t>(i)
                                    : 0x80000000u + static_cast<std::uint32_t>(count - i);
    soup.push_back(triangle);
  }
  return soup;
}

}  // namespace

TEST_CASE("Tiles hold what the reference z-buffer holds, for triangles of every size") {
  Random random{7};
  for (const double size : {0.6, 2.0, 6.0, 20.0, 90.0, 400.0}) {
    CAPTURE(size);
    check_identity(random_soup(random, 600, size, 300, 200), {0, 0, 300, 200});
  }
}

TEST_CASE("Tiles hold what the reference z-buffer holds where small triangles lie thickly over each other") {
  // Depths grow on from triangle to triangle by little: a bound that is too high by one per cent hides some.
  Random random{12};
  Soup soup = random_soup(random, 4000, 9.0, 64, 64);
  for (std::size_t i = 0; i < soup.size(); ++i) {
    const float r = 0.5f + 1e-5f * static_cast<float>(i);
    soup[i].depth = {r, 0.0f, 0.0f, 0, 0, r, r};
  }
  CHECK(check_identity(soup, {0, 0, 64, 64}).hidden_triangles > 1000);
}

TEST_CASE("Tiles of a crop hold the same pixels") {
  Random random{8};
  check_identity(random_soup(random, 500, 30.0, 300, 200), {37, 21, 150, 113});
}

TEST_CASE("Hidden triangles and blocks are left out, and counted alike by every kernel") {
  Random random{9};
  Soup soup = random_soup(random, 400, 40.0, 256, 192);
  ScreenTriangle wall;
  wall.vertices = {SnappedVertex{-1000, -1000}, {300 * 512, -1000}, {-1000, 300 * 512}};
  wall.depth = {0.9f, 0.0f, 0.0f, 0, 0, 0.9f, 0.9f};
  wall.primitive = 5;
  soup.insert(soup.begin(), wall);
  const TileCounts counts = check_identity(soup, {0, 0, 256, 192});
  CHECK(counts.hidden_triangles > 100);
  CHECK(counts.drawn_blocks > 100);
}

TEST_CASE("Tiles of the largest picture") {
  // Slivers and giants over 32768² pixels; only a strip is drawn.
  Random random{10};
  Soup soup = random_soup(random, 60, 30000.0, 32768, 32768);
  for (ScreenTriangle& triangle : soup) {
    for (SnappedVertex& v : triangle.vertices) {
      v.x = std::clamp(v.x, 0, 32768 * subpixels);
      v.y = std::clamp(v.y, 0, 32768 * subpixels);
    }
  }
  for (const Rect& rect : {Rect{0, 0, 200, 130}, Rect{32600, 32700, 168, 68}, Rect{16000, 15990, 150, 100}}) {
    check_identity(soup, rect);
  }
}

TEST_CASE("An occluder of the whole tile hides what comes before it") {
  // From back to front: without looking ahead, all of them would be drawn.
  Soup soup;
  ScreenTriangle wall;
  wall.vertices = {SnappedVertex{-1000, -1000}, {300 * 512, -1000}, {-1000, 300 * 512}};
  for (std::uint32_t i = 0; i < 20; ++i) {
    wall.primitive = i;
    wall.depth.r_ref = wall.depth.lower = wall.depth.upper = 0.04f * static_cast<float>(i + 1);
    soup.push_back(wall);
  }
  const TileCounts counts = check_identity(soup, {0, 0, 64, 64});
  CHECK(counts.hidden_triangles == 18);  // all but the last of each half
  CHECK(counts.drawn_blocks == 2 * 64);
}

TEST_CASE("What small triangles cover hides small ones behind, even those that come first") {
  // Two layers of a 12-pixel grid, the farther one first.
  Soup soup;
  std::uint32_t id = 0;
  for (const float r : {0.2f, 0.8f}) {
    for (int y = 0; y < 128; y += 12) {
      for (int x = 0; x < 128; x += 12) {
        const SnappedVertex corner[4] = {{x * subpixels, y * subpixels},
                                         {(x + 12) * subpixels, y * subpixels},
                                         {(x + 12) * subpixels, (y + 12) * subpixels},
                                         {x * subpixels, (y + 12) * subpixels}};
        soup.push_back({{corner[0], corner[1], corner[2]}, {r, 0.0f, 0.0f, 0, 0, r, r}, id++});
        soup.push_back({{corner[0], corner[2], corner[3]}, {r, 0.0f, 0.0f, 0, 0, r, r}, id++});
      }
    }
  }
  const Rect rect{0, 0, 128, 128};
  const ScreenPrimitives primitives = primitives_of(soup, TileGrid(rect));
  REQUIRE(primitives.small_count == soup.size());
  TileBins bins;
  bins.sort(primitives, TileGrid(rect));
  for (const Isa isa : available_isas()) {
    if (isa == Isa::reference) continue;
    CAPTURE(name_of(isa));
    const auto tile = std::make_unique<TileBuffer>();
    clear_tile(rect, 0, 0, *tile);
    const TilePrimitives work = bins.of_tile(0);
    TileOrder order;
    TileCounts counts;
    draw_tile(tile_raster(isa), {&work, 1}, 0, 0, order, *tile, counts);
    CHECK(counts.hidden_triangles == work.small_count / 2);
    VisibilityBuffer actual(128, 128), expected(128, 128);
    store_tile(*tile, rect, 0, 0, actual);
    rasterize_zbuffer(soup, {expected, rect});
    for (int y = 0; y < tile_size; ++y) {
      for (int x = 0; x < tile_size; ++x) CHECK(actual.primitive.at(x, y) == expected.primitive.at(x, y));
    }
  }
}

namespace {

/// Gives triangles that are set up already, and counts them.
struct Copying {
  std::vector<SmallTriangle> triangles;
  std::size_t given = 0;
  std::size_t unknown = 0;  ///< numbers that it was wrongly asked for

  static void copy(const void* work, const std::uint32_t* numbers, std::size_t count, SmallTriangle* out) {
    // The source is const for the tiles; this test has only one thread.
    Copying& self = *const_cast<Copying*>(static_cast<const Copying*>(work));
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_known = numbers[i] < self.triangles.size();
      self.unknown += !is_known;
      out[i] = is_known ? self.triangles[numbers[i]] : SmallTriangle{};
    }
    self.given += count;
  }
};

}  // namespace

TEST_CASE("Small triangles that wait are set up by their source when they are drawn, hidden ones never") {
  Random random{13};
  // Every third is ready; the others come from sources of very many and very few.
  const Soup soup = random_soup(random, 3000, 9.0, 128, 128);
  const Rect rect{0, 0, 128, 128};
  const TileGrid grid(rect);
  ScreenPrimitives primitives = primitives_of(soup, grid);
  const auto count = static_cast<std::uint32_t>(primitives.small_count);
  REQUIRE(count > 2000);
  for (std::uint32_t i = 0; i < count; ++i) {
    REQUIRE(primitives.small_refs[i] == (ready_small | i));
    if (i % 3 != 0) primitives.small_refs[i] = i;
  }
  std::vector<std::uint32_t> bounds{0, 700};
  while (bounds.back() < 1100) bounds.push_back(bounds.back() + 1 + bounds.back() % 7);
  bounds.push_back(count);
  std::vector<Copying> copying(bounds.size() - 1);
  for (std::size_t k = 0; k < copying.size(); ++k) {
    copying[k].triangles.assign(primitives.small.data() + bounds[k], primitives.small.data() + bounds[k + 1]);
    primitives.sources.push_back({Copying::copy, &copying[k], bounds[k], bounds[k + 1]});
  }
  VisibilityBuffer expected(128, 128), actual(128, 128);
  rasterize_zbuffer(soup, {expected, rect});
  TileBins bins;
  bins.sort(primitives, grid);
  const auto tile = std::make_unique<TileBuffer>();
  for (const Isa isa : available_isas()) {
    if (isa == Isa::reference) continue;
    CAPTURE(name_of(isa));
    for (Copying& source : copying) source.given = 0;
    TileOrder order;
    TileCounts counts;
    std::size_t waiting = 0;
    for (int i = 0; i < grid.count(); ++i) {
      // Twice the same part, as two batches.
      const TilePrimitives work[2] = {bins.of_tile(i), bins.of_tile(i)};
      for (std::size_t k = 0; k < work[0].small_count; ++k) {
        waiting += 2 * ((work[0].small_entries[k].ref & ready_small) == 0);
      }
      clear_tile(rect, grid.left(i), grid.top(i), *tile);
      draw_tile(tile_raster(isa), work, grid.left(i), grid.top(i), order, *tile, counts);
      store_tile(*tile, rect, grid.left(i), grid.top(i), actual);
    }
    CHECK(differences(actual, expected) == 0);
    std::size_t given = 0;
    for (const Copying& source : copying) {
      given += source.given;
      CHECK(source.unknown == 0);
    }
    CHECK(given >= waiting - counts.hidden_triangles);
    CHECK(given < waiting);
    CHECK(copying[0].given > 100);
    CHECK(copying.back().given > 100);
  }
}

TEST_CASE("Too many entries are not sorted: every tile gets every triangle, and holds the same") {
  Soup soup;
  ScreenTriangle large;
  large.vertices = {SnappedVertex{0, 0}, {32768 * subpixels, 0}, {0, 32768 * subpixels}};
  for (std::uint32_t i = 0; i < 20; ++i) {
    large.primitive = i;
    large.depth.r_ref = large.depth.lower = large.depth.upper = 0.01f * static_cast<float>(i);
    soup.push_back(large);
  }
  const Rect whole{0, 0, 32768, 32768};
  const TileGrid grid(whole);
  TileBins bins;
  const ScreenPrimitives primitives = primitives_of(soup, grid);
  bins.sort(primitives, grid);
  CHECK(bins.of_tile(0).large_count == 20);
  CHECK(bins.of_tile(grid.count() - 1).large_count == 20);

  // A tile on the slanting edge, drawn from all of them.
  const int left = 16384, top = 16384 - 64;
  VisibilityBuffer expected(tile_size, tile_size), actual(tile_size, tile_size);
  const Rect part{left, top, tile_size, tile_size};
  rasterize_zbuffer(soup, {expected, part});
  const auto tile = std::make_unique<TileBuffer>();
  TileCounts counts;
  clear_tile(part, left, top, *tile);
  const TilePrimitives work = bins.of_tile(0);
  TileOrder order;
  draw_tile(tile_raster(Isa::best), {&work, 1}, left, top, order, *tile, counts);
  store_tile(*tile, part, left, top, actual);
  CHECK(differences(actual, expected) == 0);
}

TEST_CASE("[long] Tiles hold what the reference z-buffer holds: many soups") {
  Random random{11};
  for (int round = 0; round < 200; ++round) {
    CAPTURE(round);
    const double size = 0.3 * static_cast<double>(1 << random.below(10));
    const int width = 40 + random.below(200), height = 30 + random.below(150);
    check_identity(random_soup(random, 100 + random.below(300), size, width, height),
                   {random.below(30), random.below(20), width - 30, height - 20});
  }
}
