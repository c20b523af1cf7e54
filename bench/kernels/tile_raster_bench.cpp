#include <memory>
#include <velum/visibility/draw_tile.hpp>
#include <velum/visibility/tile_bins.hpp>
#include <velum/visibility/tile_transfer.hpp>
#include <velum/visibility/zbuffer.hpp>

#include "kernels.hpp"
#include "subject.hpp"

namespace velum_bench {
namespace {

using namespace velum;

void by_reference(benchmark::State& state, const Subject& subject) {
  const std::vector<ScreenTriangle> triangles = set_up_by_reference(subject);
  VisibilityBuffer buffer;
  for (auto _ : state) {
    buffer.clear(subject.viewport.width, subject.viewport.height);
    rasterize_zbuffer(triangles, {.buffer = buffer, .rect = subject.rect()});
    benchmark::ClobberMemory();
  }
}

/// Every tile cleared and drawn; sorting into tiles and storing them are left out.
void by_kernel(benchmark::State& state, const Subject& subject, Isa isa) {
  const Rect rect = subject.rect();
  const TileGrid grid(rect);
  const std::vector<ScreenTriangle> triangles = set_up_by_reference(subject);
  ScreenPrimitives primitives;
  primitives.make_room(triangles.size());
  for (const ScreenTriangle& triangle : triangles) append_triangle(triangle, grid, primitives);
  TileBins bins;
  bins.sort(primitives, grid);
  const auto tile = std::make_unique<TileBuffer>();
  const TileRaster raster = tile_raster(isa);
  TileOrder order;
  TileCounts counts;
  for (auto _ : state) {
    for (int i = 0; i < grid.count(); ++i) {
      const TilePrimitives work = bins.of_tile(i);
      clear_tile(rect, grid.left(i), grid.top(i), *tile);
      draw_tile(raster, {&work, 1}, grid.left(i), grid.top(i), order, *tile, counts);
      benchmark::ClobberMemory();
    }
  }
}

}  // namespace

void register_tile_raster() {
  register_kernel("tile_raster", [](benchmark::State& state, const Subject& subject, Isa isa) {
    if (isa == Isa::reference) {
      by_reference(state, subject);
    } else {
      by_kernel(state, subject, isa);
    }
    count_items(state, subject.mesh.triangles.size());
  });
}

}  // namespace velum_bench
