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

/// Triangles come from the whole batch: one of as many turns on is asked for beforehand.
constexpr std::size_t large_ahead = 3;

void find_tile_occluder(const TilePrimitives& work, int left, int top, TileBuffer& tile) {
  for (std::size_t i = 0; i < work.large_count; ++i) {
    const LargeEntry& entry = work.large_entries[i];
    if (entry.may_occlude) raise_occluder(work.large[entry.index], left, top, tile);
  }
}

void draw_large_in_tile(const LargeInTile* triangles, std::size_t count, int left, int top, TileBuffer& tile,
                        TileCounts& counts) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i + large_ahead < count) hwy::Prefetch(triangles[i + large_ahead].triangle);
    if (tile.has_occluder && triangles[i].nearest < HWY_MAX(tile.occluder, farthest_of_all(tile))) {
      ++counts.hidden_triangles;
    } else {
      draw_large(*triangles[i].triangle, left, top, tile, counts);
    }
  }
}

/// Fills in the numbers of those that are not hidden. @return how many
HWY_INLINE std::size_t find_seen(const SmallInTile* triangles, std::size_t count, const TileBuffer& tile,
                                 std::uint32_t* out) {
  std::size_t seen = 0;
  for (std::size_t i = 0; i < count; ++i) {
    out[seen] = static_cast<std::uint32_t>(i);
    seen += !(triangles[i].nearest < farthest_in(triangles[i].blocks, tile));
  }
  return seen;
}

/// The source that a triangle of this number is of: there may be thousands.
HWY_INLINE const SmallSource* source_of(std::uint32_t ref, const TilePrimitives& part) {
  const SmallSource* first = part.small_sources;
  for (std::size_t count = part.small_source_count; count > 1;) {
    const std::size_t half = count / 2;
    first += ref >= first[half].first ? half : 0;
    count -= half;
  }
  return first;
}

/// Small triangles on their way into a tile.
class SmallDrawing {
 public:
  SmallDrawing(int left, int top, TileBuffer& tile) : left_(left), top_(top), tile_(tile) {}

  HWY_INLINE void add(const SmallInTile& t, const TilePrimitives& part) {
    tile_.touched |= bits_of(t.blocks);
    if ((t.ref & ready_small) != 0) return draw_small(part.small[t.ref & ~ready_small], left_, top_, tile_);
    const bool is_of_source =
        source_ != nullptr && t.part == part_ && t.ref >= source_->first && t.ref < source_->end;
    if (!is_of_source || count_ == most_waiting) draw_waiting();
    if (!is_of_source) {
      part_ = t.part;
      source_ = source_of(t.ref, part);
    }
    waiting_[count_++] = t.ref - source_->first;
  }

  /// Sets up those that wait, and draws them.
  void draw_waiting() {
    if (count_ == 0) return;
    source_->set_up(source_->work, waiting_, count_, triangles_);
    for (std::size_t i = 0; i < count_; ++i) draw_small(triangles_[i], left_, top_, tile_);
    count_ = 0;
  }

 private:
  static constexpr std::size_t most_waiting = 64;

  const int left_, top_;
  TileBuffer& tile_;
  const SmallSource* source_ = nullptr;  ///< of those that wait
  std::uint32_t part_ = 0;
  std::size_t count_ = 0;
  std::uint32_t waiting_[most_waiting];
  SmallTriangle triangles_[most_waiting];
};

void draw_small_in_tile(const SmallInTile* triangles, std::size_t count, const TilePrimitives* parts,
                        int left, int top, TileBuffer& tile, TileCounts& counts) {
  constexpr std::size_t most_at_once = 1024;
  std::uint32_t seen[most_at_once];
  SmallDrawing drawing(left, top, tile);
  for (std::size_t first = 0; first < count; first += most_at_once) {
    const std::size_t here = HWY_MIN(most_at_once, count - first);
    const std::size_t seen_count = find_seen(triangles + first, here, tile, seen);
    counts.hidden_triangles += here - seen_count;
    for (std::size_t i = 0; i < seen_count; ++i) {
      const SmallInTile& t = triangles[first + seen[i]];
      drawing.add(t, parts[t.part]);
    }
  }
  drawing.draw_waiting();
}

void find_farthest_in_tile(TileBuffer& tile) {
  raise_farthest(tile);
}

void draw_fragments_in_tile(const RasterFragment* fragments, std::size_t count, TileBuffer& tile) {
  draw_fragments(fragments, count, tile);
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

TileRaster tile_raster(Isa isa) {
  static constexpr auto find_occluder = VELUM_KERNEL_VERSIONS(find_tile_occluder);
  static constexpr auto large = VELUM_KERNEL_VERSIONS(draw_large_in_tile);
  static constexpr auto small = VELUM_KERNEL_VERSIONS(draw_small_in_tile);
  static constexpr auto farthest = VELUM_KERNEL_VERSIONS(find_farthest_in_tile);
  static constexpr auto fragments = VELUM_KERNEL_VERSIONS(draw_fragments_in_tile);
  return {find_occluder.at(isa), large.at(isa), small.at(isa), farthest.at(isa), fragments.at(isa)};
}

}  // namespace velum
#endif
