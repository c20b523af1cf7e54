// Small triangles and fragments in a tile; see tile_raster_simd.cpp.
#if defined(VELUM_TILE_SMALL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_TILE_SMALL_INL
#undef VELUM_TILE_SMALL_INL
#else
#define VELUM_TILE_SMALL_INL
#endif

#include "raster_triangle.hpp"
#include "tile_lanes-inl.hpp"
#include "tile_raster.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// The edge functions of a small triangle and their steps.
struct SmallEdges {
  Int value[3];   ///< at the pixels that the lanes stand for
  Int across[3];  ///< to the strip on the right
  Int down[3];    ///< to the rows that are drawn next

  /// @param x, y  the first lane's pixel, from the triangle's first
  HWY_INLINE SmallEdges(const SmallTriangle& t, int x, int y) {
    for (int i = 0; i < 3; ++i) {
      const Int step_x = hn::Set(ints, t.step_x[i]), step_y = hn::Set(ints, t.step_y[i]);
      const Int lanes = hn::Add(hn::Mul(step_x, lane_column()), hn::Mul(step_y, lane_row()));
      value[i] = hn::Add(hn::Set(ints, t.edge[i] + t.step_x[i] * x + t.step_y[i] * y), lanes);
      across[i] = hn::Set(ints, t.step_x[i] * strip_width);
      down[i] = hn::Set(ints, t.step_y[i] * rows_at_once);
    }
  }
};

/// A lower bound of what stands in the blocks of a box.
HWY_INLINE float farthest_in(const BlockBox& box, const TileBuffer& tile) {
  const float* const top = tile.farthest + box.first_row * blocks_per_tile;
  const float* const bottom = tile.farthest + box.last_row * blocks_per_tile;
  float farthest = HWY_MIN(HWY_MIN(top[box.first_column], top[box.last_column]),
                           HWY_MIN(bottom[box.first_column], bottom[box.last_column]));
  // Seldom are there blocks between the corners.
  if (box.last_column - box.first_column > 1 || box.last_row - box.first_row > 1) {
    for (int row = box.first_row; row <= box.last_row; ++row) {
      for (int column = box.first_column; column <= box.last_column; ++column) {
        farthest = HWY_MIN(farthest, tile.farthest[row * blocks_per_tile + column]);
      }
    }
  }
  return HWY_MAX(farthest, tile.occluder);
}

/// Draws a small triangle strip by strip, each from the top of its box to the bottom.
HWY_INLINE void draw_small(const SmallTriangle& t, int left, int top, TileBuffer& tile) {
  const int first_x = HWY_MAX(t.left - left, 0) & -strip_width,
            last_x = HWY_MIN(t.right - left, tile_size - 1);
  const int first_y = HWY_MAX(t.top - top, 0) & -rows_at_once,
            last_y = HWY_MIN(t.bottom - top, tile_size - 1);
  SmallEdges edges(t, left + first_x - t.left, top + first_y - t.top);
  const DepthLanes plane(t);
  const Int id = hn::Set(ints, static_cast<std::int32_t>(t.primitive ^ 0x80000000u));
  const Float strip = hn::Set(floats, static_cast<float>(strip_width));
  const Float rows = hn::Set(floats, static_cast<float>(rows_at_once));
  Float x = hn::ConvertTo(floats, hn::Add(hn::Set(ints, left + first_x - t.x_ref), lane_column()));
  const Float first_row = hn::ConvertTo(floats, hn::Add(hn::Set(ints, top + first_y - t.y_ref), lane_row()));
  for (int strip_x = first_x; strip_x <= last_x; strip_x += strip_width) {
    Int e0 = edges.value[0], e1 = edges.value[1], e2 = edges.value[2];
    const Float columns = plane.columns(x);
    Float y = first_row;
    const int end = tile_place(strip_x, last_y);
    for (int at = tile_place(strip_x, first_y); at <= end; at += rows_at_once * block_size) {
      merge(plane.bits(columns, y), id, hn::Or(e0, hn::Or(e1, e2)), tile.depth + at, tile.primitive + at);
      e0 = hn::Add(e0, edges.down[0]);
      e1 = hn::Add(e1, edges.down[1]);
      e2 = hn::Add(e2, edges.down[2]);
      y = hn::Add(y, rows);
    }
    for (int i = 0; i < 3; ++i) edges.value[i] = hn::Add(edges.value[i], edges.across[i]);
    x = hn::Add(x, strip);
  }
}

/// The blocks of a box, a bit each.
HWY_INLINE std::uint64_t bits_of(const BlockBox& box) {
  const std::uint64_t columns = (2u << box.last_column) - (1u << box.first_column);
  const std::uint64_t below = ~std::uint64_t{0} << (8 * box.first_row);
  const std::uint64_t above = ~std::uint64_t{0} >> (56 - 8 * box.last_row);
  return columns * 0x0101010101010101u & below & above;
}
static_assert(blocks_per_tile == 8);

HWY_INLINE void raise_farthest(TileBuffer& tile) {
  for (; tile.touched != 0; tile.touched &= tile.touched - 1) {
    const auto block = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(tile.touched));
    const int left = block % blocks_per_tile * block_size, top = block / blocks_per_tile * block_size;
    const std::int32_t* const depth = tile.depth + tile_place(left, top);
    Int farthest = hn::Load(ints, depth);
    for (int i = lane_count; i < block_pixels; i += lane_count) {
      farthest = hn::Min(farthest, hn::Load(ints, depth + i));
    }
    const std::int32_t bits = hn::GetLane(hn::MinOfLanes(ints, farthest));
    tile.farthest[block] = hn::GetLane(hn::BitCast(floats, hn::Set(ints, bits)));
    tile.has_occluder = tile.has_occluder || bits > 0;
  }
}

/// Keeps the nearer of each fragment and what stands in its place.
HWY_INLINE void draw_fragments(const RasterFragment* fragments, std::size_t count, TileBuffer& tile) {
  for (std::size_t i = 0; i < count; ++i) {
    const RasterFragment& f = fragments[i];
    const std::size_t at = f.place % fragment_places;
    const auto id = static_cast<std::int32_t>(f.primitive ^ 0x80000000u);
    const std::int32_t old_r = tile.depth[at], old_id = tile.primitive[at];
    const bool wins = f.depth > old_r - (id < old_id ? 1 : 0);
    tile.depth[at] = wins ? f.depth : old_r;
    tile.primitive[at] = wins ? id : old_id;
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
