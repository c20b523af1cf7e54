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

/// A small triangle in every lane: edge functions and depth, and how they differ from lane to lane.
struct SmallLanes {
  const DepthLanes plane;
  const Int id;
  Int edge[3];  ///< the lanes' differences to the first lane
  Int down[3];  ///< the step to the rows that are drawn next

  HWY_INLINE explicit SmallLanes(const SmallTriangle& t)
      : plane(t), id(hn::Set(ints, static_cast<std::int32_t>(t.primitive ^ 0x80000000u))) {
    for (int i = 0; i < 3; ++i) {
      const Int x = hn::Set(ints, t.step_x[i]), y = hn::Set(ints, t.step_y[i]);
      edge[i] = hn::Add(hn::Mul(x, lane_column()), hn::Mul(y, lane_row()));
      down[i] = hn::Set(ints, t.step_y[i] * rows_at_once);
    }
  }

  /// Edge i at the pixels that begin with offset (x, y) from the triangle's first pixel.
  HWY_INLINE Int edge_at(const SmallTriangle& t, int i, int x, int y) const {
    return hn::Add(hn::Set(ints, t.edge[i] + t.step_x[i] * x + t.step_y[i] * y), edge[i]);
  }
};

/// Draws a small triangle's rows first … last of one block.
/// @param x, y  the block's first pixel in the picture
HWY_INLINE void draw_small_in_block(const SmallTriangle& t, const SmallLanes& s, int x, int y, int first,
                                    int last, std::int32_t* depth, std::int32_t* primitive) {
  first &= -rows_at_once;
  const Float fx = hn::ConvertTo(floats, lane_column());
  const Float fy = hn::ConvertTo(floats, lane_row());
  for (int strip = 0; strip < block_size; strip += strip_width) {
    Int e0 = s.edge_at(t, 0, x + strip - t.left, y + first - t.top);
    Int e1 = s.edge_at(t, 1, x + strip - t.left, y + first - t.top);
    Int e2 = s.edge_at(t, 2, x + strip - t.left, y + first - t.top);
    const Float columns =
        s.plane.columns(hn::Add(hn::Set(floats, static_cast<float>(x + strip - t.x_ref)), fx));
    Float row = hn::Add(hn::Set(floats, static_cast<float>(y + first - t.y_ref)), fy);
    for (int at = first * block_size + strip; at <= last * block_size + strip;
         at += rows_at_once * block_size) {
      merge(s.plane.bits(columns, row), s.id, hn::Or(e0, hn::Or(e1, e2)), depth + at, primitive + at);
      e0 = hn::Add(e0, s.down[0]);
      e1 = hn::Add(e1, s.down[1]);
      e2 = hn::Add(e2, s.down[2]);
      row = hn::Add(row, hn::Set(floats, static_cast<float>(rows_at_once)));
    }
  }
}

/// The part of a small triangle's box that lies in the tile, in its pixels.
struct BoxInTile {
  int left, top, right, bottom;
};
HWY_INLINE BoxInTile box_in_tile(const SmallTriangle& t, int left, int top) {
  return {HWY_MAX(t.left - left, 0), HWY_MAX(t.top - top, 0), HWY_MIN(t.right - left, tile_size - 1),
          HWY_MIN(t.bottom - top, tile_size - 1)};
}

/// Whether everything that the box meets is nearer than the triangle's nearest vertex.
HWY_INLINE bool is_hidden(const SmallTriangle& t, const BoxInTile& box, const TileBuffer& tile) {
  if (t.upper < tile.occluder) return true;
  for (int row = box.top / block_size; row <= box.bottom / block_size; ++row) {
    for (int column = box.left / block_size; column <= box.right / block_size; ++column) {
      if (!(t.upper < tile.farthest[row * blocks_per_tile + column])) return false;
    }
  }
  return true;
}

HWY_INLINE void draw_small(const SmallTriangle& t, int left, int top, TileBuffer& tile, TileCounts& counts) {
  const BoxInTile box = box_in_tile(t, left, top);
  if (tile.has_occluder && is_hidden(t, box, tile)) {
    ++counts.hidden_triangles;
    return;
  }
  const SmallLanes lanes(t);
  for (int y = box.top & -block_size; y <= box.bottom; y += block_size) {
    const int first = HWY_MAX(box.top - y, 0), last = HWY_MIN(box.bottom - y, block_size - 1);
    for (int x = box.left & -block_size; x <= box.right; x += block_size) {
      const int at = tile_place(x, y);
      draw_small_in_block(t, lanes, left + x, top + y, first, last, tile.depth + at, tile.primitive + at);
    }
  }
}

/// Keeps the nearer of each fragment and what stands in its place.
HWY_INLINE void draw_fragments(const RasterFragment* fragments, std::size_t count, TileBuffer& tile) {
  for (std::size_t i = 0; i < count; ++i) {
    const RasterFragment& f = fragments[i];
    const std::size_t at = f.place % tile_pixels;
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
