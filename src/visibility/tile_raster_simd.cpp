#include "tile_raster.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/tile_raster_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"
#include "tile_large-inl.hpp"
#include "tile_small-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {

/// Triangles come from the whole batch: those of as many turns on are asked for beforehand.
constexpr std::size_t small_ahead = 8;

void draw_in_tile(const TilePrimitives& work, int left, int top, TileBuffer& tile, TileCounts& counts) {
  for (std::size_t i = 0; i < work.large_count; ++i) {
    draw_large(work.large[work.large_indices[i]], left, top, tile, counts);
  }
  for (std::size_t i = 0; i < work.small_count; ++i) {
    if (i + small_ahead < work.small_count) hwy::Prefetch(work.small + work.small_indices[i + small_ahead]);
    draw_small(work.small[work.small_indices[i]], left, top, tile, counts);
  }
  draw_fragments(work.fragments, work.fragment_count, tile);
}

void find_tile_occluder(const TilePrimitives& work, int left, int top, TileBuffer& tile) {
  for (std::size_t i = 0; i < work.large_count; ++i) {
    raise_occluder(work.large[work.large_indices[i]], left, top, tile);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

TileRaster tile_raster(Isa isa) {
  static constexpr auto draw = VELUM_KERNEL_VERSIONS(draw_in_tile);
  static constexpr auto find_occluder = VELUM_KERNEL_VERSIONS(find_tile_occluder);
  return {draw.at(isa), find_occluder.at(isa)};
}

}  // namespace velum
#endif
