#include "tile_raster.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "visibility/tile_raster_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's header is read anew for every target; it must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Ints = hn::CappedTag<std::int32_t, block_size>;
using Floats = hn::CappedTag<float, block_size>;
using Int = hn::Vec<Ints>;
using Float = hn::Vec<Floats>;
constexpr Ints ints;
constexpr Floats floats;

/// One edge function within the tile, in 1/256 of EdgeFunction's unit. All its values there differ by
/// multiples of 256, so rounding down keeps every sign and makes 32 bits enough.
struct TileEdge {
  std::int32_t value;   ///< at the centre of the tile's first pixel
  std::int32_t step_x;  ///< per pixel to the right
  std::int32_t step_y;  ///< per pixel downwards
};

struct Span {
  int first;
  int last;
};

/// From the smallest to the largest coordinate.
HWY_INLINE std::int32_t extent(const std::int32_t (&v)[3]) {
  return HWY_MAX(v[0], HWY_MAX(v[1], v[2])) - HWY_MIN(v[0], HWY_MIN(v[1], v[2]));
}

/// The pixels of the tile, along one axis, whose centres lie between the smallest and largest coordinate.
HWY_INLINE Span covered(const std::int32_t (&v)[3], int tile_first) {
  const std::int32_t lowest = HWY_MIN(v[0], HWY_MIN(v[1], v[2]));
  const std::int32_t highest = HWY_MAX(v[0], HWY_MAX(v[1], v[2]));
  const int first = ((lowest + 127) >> 8) - tile_first;
  const int last = ((highest - 128) >> 8) - tile_first;
  return {HWY_MAX(first, 0), HWY_MIN(last, tile_size - 1)};
}

/// How far an edge function can rise and fall over the pixels between the corners of a window.
struct Reach {
  std::int64_t up;
  std::int64_t down;
};
HWY_INLINE Reach reach_over(std::int64_t step_x, std::int64_t step_y, const Span& x, const Span& y) {
  const std::int64_t left = step_x * x.first, right = step_x * x.last;
  const std::int64_t top = step_y * y.first, bottom = step_y * y.last;
  return {HWY_MAX(left, right) + HWY_MAX(top, bottom), HWY_MIN(left, right) + HWY_MIN(top, bottom)};
}

/// @return false if no centre of the window is inside the edge
HWY_INLINE bool set_up_edge(const RasterTriangle& t, int from, int to, int left, int top, const Span& x,
                            const Span& y, TileEdge& edge) {
  const std::int64_t dx = t.x[to] - t.x[from];
  const std::int64_t dy = t.y[to] - t.y[from];
  const std::int64_t px = static_cast<std::int64_t>(left) * 256 + 128 - t.x[from];
  const std::int64_t py = static_cast<std::int64_t>(top) * 256 + 128 - t.y[from];
  const bool owns_its_points = dy < 0 || (dy == 0 && dx > 0);
  const std::int64_t value = (dx * py - dy * px - (owns_its_points ? 0 : 1)) >> 8;
  const Reach reach = reach_over(-dy, dx, x, y);
  if (value + reach.up < 0) return false;
  if (value + reach.down >= 0) {
    edge = {0, 0, 0};  // the whole window is inside; the numbers themselves may not fit 32 bits
  } else {
    edge = {static_cast<std::int32_t>(value), static_cast<std::int32_t>(-dy), static_cast<std::int32_t>(dx)};
  }
  return true;
}

/// The same for a triangle of less than small_extent: everything fits 32 bits, and its box is so small that
/// no edge is worth a look at the window.
constexpr std::int32_t small_extent = 1 << 13;
HWY_INLINE TileEdge small_edge(const RasterTriangle& t, int from, int to, int left, int top) {
  const std::int32_t dx = t.x[to] - t.x[from];
  const std::int32_t dy = t.y[to] - t.y[from];
  const std::int32_t px = left * 256 + 128 - t.x[from];
  const std::int32_t py = top * 256 + 128 - t.y[from];
  const bool owns_its_points = dy < 0 || (dy == 0 && dx > 0);
  return {(dx * py - dy * px - (owns_its_points ? 0 : 1)) >> 8, -dy, dx};
}

/// A triangle within the tile.
struct TileTriangle {
  TileEdge edges[3];
  Span x;
  Span y;
  std::int32_t primitive;  ///< top bit turned over, as in TileBuffer
  int x_from_ref;          ///< of the tile's first pixel
  int y_from_ref;
};

/// @param window_x, window_y  the pixels that will be looked at; they contain t.x, t.y
HWY_INLINE bool set_up_edges(const RasterTriangle& t, int left, int top, const Span& window_x,
                             const Span& window_y, TileTriangle& out) {
  return set_up_edge(t, 0, 1, left, top, window_x, window_y, out.edges[0]) &&
         set_up_edge(t, 1, 2, left, top, window_x, window_y, out.edges[1]) &&
         set_up_edge(t, 2, 0, left, top, window_x, window_y, out.edges[2]);
}

/// Edge values of the pixels x … x+lanes-1 of row y.
HWY_INLINE Int edge_row(const TileEdge& edge, int x, int y) {
  const Int first = hn::Set(ints, edge.value + edge.step_x * x + edge.step_y * y);
  return hn::Add(first, hn::Mul(hn::Set(ints, edge.step_x), hn::Iota(ints, 0)));
}

/// r_ref + dx·(x - x_ref) of the pixels x … x+lanes-1.
HWY_INLINE Float depth_columns(const RasterTriangle& t, int x_from_ref) {
  const Float offset = hn::ConvertTo(floats, hn::Add(hn::Set(ints, x_from_ref), hn::Iota(ints, 0)));
  return hn::Add(hn::Set(floats, t.r_ref), hn::Mul(hn::Set(floats, t.dx), offset));
}

/// The rest of DepthPlane::at.
HWY_INLINE Int depth_bits(const RasterTriangle& t, Float columns, int y_from_ref) {
  const Float row = hn::Set(floats, t.dy * static_cast<float>(y_from_ref));
  const Float r = hn::Max(hn::Add(columns, row), hn::Set(floats, t.lower));
  return hn::BitCast(ints, hn::Min(r, hn::Set(floats, t.upper)));
}

/// is_nearer as integers: r > buffer, or r = buffer and the id is smaller.
HWY_INLINE hn::Mask<Ints> nearer(Int r, Int id, Int buffer_r, Int buffer_id) {
  const Int wins_ties = hn::VecFromMask(ints, hn::Gt(buffer_id, id));
  return hn::Gt(r, hn::Add(buffer_r, wins_ties));
}

/// Compares and writes the lanes where `outside` is not negative.
/// @return the depths that stand there now
HWY_INLINE Int merge(Int r, Int id, Int outside, std::int32_t* depth, std::int32_t* primitive) {
  const Int old_r = hn::LoadU(ints, depth);
  const Int old_id = hn::LoadU(ints, primitive);
  const Int is_outside = hn::BroadcastSignBit(outside);
  const auto write =
      hn::MaskFromVec(hn::AndNot(is_outside, hn::VecFromMask(ints, nearer(r, id, old_r, old_id))));
  const Int new_r = hn::IfThenElse(write, r, old_r);
  hn::StoreU(new_r, ints, depth);
  hn::StoreU(hn::IfThenElse(write, id, old_id), ints, primitive);
  return new_r;
}

/// A triangle a few pixels wide: row by row over its box.
HWY_INLINE void draw_rows(const RasterTriangle& t, const TileTriangle& s, TileBuffer& tile) {
  const int lanes = static_cast<int>(hn::Lanes(ints));
  const Int id = hn::Set(ints, s.primitive);
  for (int x = s.x.first; x <= s.x.last; x += lanes) {
    Int e0 = edge_row(s.edges[0], x, s.y.first);
    Int e1 = edge_row(s.edges[1], x, s.y.first);
    Int e2 = edge_row(s.edges[2], x, s.y.first);
    const Float columns = depth_columns(t, s.x_from_ref + x);
    for (int y = s.y.first; y <= s.y.last; ++y) {
      const Int outside = hn::Or(e0, hn::Or(e1, e2));
      const int at = y * tile_stride + x;
      merge(depth_bits(t, columns, s.y_from_ref + y), id, outside, tile.depth + at, tile.primitive + at);
      e0 = hn::Add(e0, hn::Set(ints, s.edges[0].step_y));
      e1 = hn::Add(e1, hn::Set(ints, s.edges[1].step_y));
      e2 = hn::Add(e2, hn::Set(ints, s.edges[2].step_y));
    }
  }
}

/// One 8×8 block. @param is_full  every centre is inside: no edge is looked at
template <bool is_full>
HWY_INLINE void draw_block(const RasterTriangle& t, const TileTriangle& s, int left, int top,
                           TileBuffer& tile) {
  const int lanes = static_cast<int>(hn::Lanes(ints));
  const Int id = hn::Set(ints, s.primitive);
  Int farthest = hn::Set(ints, 0x7f800000);  // +infinity
  for (int x = left; x < left + block_size; x += lanes) {
    const Float columns = depth_columns(t, s.x_from_ref + x);
    Int e0 = hn::Zero(ints), e1 = hn::Zero(ints), e2 = hn::Zero(ints);
    if (!is_full) {
      e0 = edge_row(s.edges[0], x, top);
      e1 = edge_row(s.edges[1], x, top);
      e2 = edge_row(s.edges[2], x, top);
    }
    for (int y = top; y < top + block_size; ++y) {
      const int at = y * tile_stride + x;
      const Int outside = hn::Or(e0, hn::Or(e1, e2));
      farthest = hn::Min(farthest, merge(depth_bits(t, columns, s.y_from_ref + y), id, outside,
                                         tile.depth + at, tile.primitive + at));
      if (!is_full) {
        e0 = hn::Add(e0, hn::Set(ints, s.edges[0].step_y));
        e1 = hn::Add(e1, hn::Set(ints, s.edges[1].step_y));
        e2 = hn::Add(e2, hn::Set(ints, s.edges[2].step_y));
      }
    }
  }
  const std::int32_t bits = hn::GetLane(hn::MinOfLanes(ints, farthest));
  float& bound = tile.farthest[top / block_size * blocks_per_tile + left / block_size];
  bound = hn::GetLane(hn::BitCast(floats, hn::Set(ints, bits)));
  tile.has_occluder = tile.has_occluder || bits > 0;
}

/// What the edges say of a row of blocks: bit i is the block in column i.
struct BlockRow {
  std::uint32_t outside;  ///< no centre inside
  std::uint32_t full;     ///< every centre inside
  std::uint32_t hidden;   ///< nothing of the triangle's plane is as near as the farthest depth there
};

HWY_INLINE std::uint32_t bits_of(hn::Mask<Ints> mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(ints, mask, bits);
  return bits[0];
}

/// Bounds at the corners of all blocks in a row of the tile, several at a time (Greene 1996).
HWY_INLINE BlockRow classify(const RasterTriangle& t, const TileTriangle& s, int top,
                             const TileBuffer& tile) {
  const int lanes = static_cast<int>(hn::Lanes(ints));
  constexpr int reach = block_size - 1;
  BlockRow row{0, 0, 0};
  for (int block = 0; block < blocks_per_tile; block += lanes) {
    const Int column = hn::Mul(hn::Add(hn::Iota(ints, 0), hn::Set(ints, block)), hn::Set(ints, block_size));
    Int highest_or = hn::Zero(ints);  // negative where one edge has no centre inside
    Int lowest_or = hn::Zero(ints);   // negative where one edge has a centre outside
    for (const TileEdge& edge : s.edges) {
      const Int corner =
          hn::Add(hn::Set(ints, edge.value + edge.step_y * top), hn::Mul(hn::Set(ints, edge.step_x), column));
      const std::int32_t up = (HWY_MAX(edge.step_x, 0) + HWY_MAX(edge.step_y, 0)) * reach;
      const std::int32_t down = (HWY_MIN(edge.step_x, 0) + HWY_MIN(edge.step_y, 0)) * reach;
      highest_or = hn::Or(highest_or, hn::Add(corner, hn::Set(ints, up)));
      lowest_or = hn::Or(lowest_or, hn::Add(corner, hn::Set(ints, down)));
    }
    const int nearest_x = s.x_from_ref + (t.dx > 0.0f ? reach : 0);
    const int nearest_y = s.y_from_ref + top + (t.dy > 0.0f ? reach : 0);
    const Float offset = hn::ConvertTo(floats, hn::Add(column, hn::Set(ints, nearest_x)));
    const Float columns = hn::Add(hn::Set(floats, t.r_ref), hn::Mul(hn::Set(floats, t.dx), offset));
    const Int nearest = depth_bits(t, columns, nearest_y);
    const Int farthest =
        hn::BitCast(ints, hn::LoadU(floats, tile.farthest + top / block_size * blocks_per_tile + block));
    row.outside |= bits_of(hn::Lt(highest_or, hn::Zero(ints))) << block;
    row.full |= bits_of(hn::Not(hn::Lt(lowest_or, hn::Zero(ints)))) << block;
    row.hidden |= bits_of(hn::Lt(nearest, farthest)) << block;
  }
  return row;
}

HWY_INLINE std::uint32_t bits_between(int first, int last) {
  return (2u << last) - (1u << first);
}

HWY_INLINE void draw_blocks(const RasterTriangle& t, const TileTriangle& s, TileBuffer& tile,
                            TileCounts& counts) {
  const std::uint32_t in_box = bits_between(s.x.first / block_size, s.x.last / block_size);
  for (int top = s.y.first / block_size * block_size; top <= s.y.last; top += block_size) {
    const BlockRow row = classify(t, s, top, tile);
    const std::uint32_t met = in_box & ~row.outside;
    std::uint32_t left_to_draw = met & ~row.hidden;
    counts.hidden_blocks += hwy::PopCount(met & row.hidden);
    counts.drawn_blocks += hwy::PopCount(left_to_draw);
    for (; left_to_draw != 0; left_to_draw &= left_to_draw - 1) {
      const int column = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(left_to_draw));
      if ((row.full >> column) & 1u) {
        draw_block<true>(t, s, column * block_size, top, tile);
      } else {
        draw_block<false>(t, s, column * block_size, top, tile);
      }
    }
  }
}

/// Whether everything that the triangle's box meets is nearer than its nearest vertex.
HWY_INLINE bool is_hidden(const RasterTriangle& t, const TileTriangle& s, const TileBuffer& tile) {
  for (int row = s.y.first / block_size; row <= s.y.last / block_size; ++row) {
    for (int column = s.x.first / block_size; column <= s.x.last / block_size; ++column) {
      if (!(t.upper < tile.farthest[row * blocks_per_tile + column])) return false;
    }
  }
  return true;
}

HWY_INLINE void draw_triangle(const RasterTriangle& t, int left, int top, TileBuffer& tile,
                              TileCounts& counts) {
  TileTriangle s;
  s.x = covered(t.x, left);
  s.y = covered(t.y, top);
  if (s.x.first > s.x.last || s.y.first > s.y.last) return;
  if (tile.has_occluder && is_hidden(t, s, tile)) {
    ++counts.hidden_triangles;
    return;
  }
  s.primitive = static_cast<std::int32_t>(t.primitive ^ 0x80000000u);
  s.x_from_ref = left - t.x_ref;
  s.y_from_ref = top - t.y_ref;
  if (s.x.last - s.x.first < block_size && extent(t.x) < small_extent && extent(t.y) < small_extent) {
    for (int i = 0; i < 3; ++i) s.edges[i] = small_edge(t, i, i == 2 ? 0 : i + 1, left, top);
    draw_rows(t, s, tile);
    return;
  }
  if (s.x.last - s.x.first < block_size) {
    // A vector may run over the box on the right.
    const Span window_x{s.x.first, s.x.first + block_size - 1};
    if (set_up_edges(t, left, top, window_x, s.y, s)) draw_rows(t, s, tile);
    return;
  }
  const Span window_x{s.x.first / block_size * block_size, s.x.last | (block_size - 1)};
  const Span window_y{s.y.first / block_size * block_size, s.y.last | (block_size - 1)};
  if (set_up_edges(t, left, top, window_x, window_y, s)) draw_blocks(t, s, tile, counts);
}

}  // namespace

void rasterize_tile(const TileTriangles& work, int left, int top, TileBuffer& tile, TileCounts& counts) {
  for (std::size_t i = 0; i < work.count; ++i) {
    draw_triangle(work.triangles[work.indices[i]], left, top, tile, counts);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

RasterizeTile tile_raster(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(rasterize_tile);
  return versions.at(isa);
}

}  // namespace velum
#endif
