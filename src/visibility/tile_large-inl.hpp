// Triangles of any size in a tile, block by block; see tile_raster_simd.cpp.
#if defined(VELUM_TILE_LARGE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_TILE_LARGE_INL
#undef VELUM_TILE_LARGE_INL
#else
#define VELUM_TILE_LARGE_INL
#endif

#include "raster_triangle.hpp"
#include "tile_lanes-inl.hpp"
#include "tile_raster.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// One edge function within the tile, in 1/256 of EdgeFunction's unit. All its values there differ by
/// multiples of 256, so rounding down keeps every sign and makes 32 bits enough.
struct TileEdge {
  std::int32_t value;   ///< at the centre of the tile's first pixel
  std::int32_t step_x;  ///< per pixel to the right
  std::int32_t step_y;  ///< per pixel downwards
};

struct PixelSpan {
  int first;
  int last;
};

/// The pixels of the tile, along one axis, whose centres lie between the smallest and largest coordinate.
HWY_INLINE PixelSpan covered(const std::int32_t (&v)[3], int tile_first, int size) {
  const std::int32_t lowest = HWY_MIN(v[0], HWY_MIN(v[1], v[2]));
  const std::int32_t highest = HWY_MAX(v[0], HWY_MAX(v[1], v[2]));
  const int first = ((lowest + 127) >> 8) - tile_first;
  const int last = ((highest - 128) >> 8) - tile_first;
  return {HWY_MAX(first, 0), HWY_MIN(last, size - 1)};
}

/// How far an edge function can rise and fall over the pixels between the corners of a window.
struct Reach {
  std::int64_t up;
  std::int64_t down;
};
HWY_INLINE Reach reach_over(std::int64_t step_x, std::int64_t step_y, const PixelSpan& x,
                            const PixelSpan& y) {
  const std::int64_t left = step_x * x.first, right = step_x * x.last;
  const std::int64_t top = step_y * y.first, bottom = step_y * y.last;
  return {HWY_MAX(left, right) + HWY_MAX(top, bottom), HWY_MIN(left, right) + HWY_MIN(top, bottom)};
}

/// An edge function of the picture at the centre of the tile's first pixel, in TileEdge's unit.
struct WideEdge {
  std::int64_t value, step_x, step_y;
};
HWY_INLINE WideEdge wide_edge(const RasterTriangle& t, int from, int left, int top) {
  const int to = from == 2 ? 0 : from + 1;
  const std::int64_t dx = t.x[to] - t.x[from];
  const std::int64_t dy = t.y[to] - t.y[from];
  const std::int64_t px = static_cast<std::int64_t>(left) * 256 + 128 - t.x[from];
  const std::int64_t py = static_cast<std::int64_t>(top) * 256 + 128 - t.y[from];
  const bool owns_its_points = dy < 0 || (dy == 0 && dx > 0);
  return {(dx * py - dy * px - (owns_its_points ? 0 : 1)) >> 8, -dy, dx};
}

/// A triangle within the tile.
struct TileTriangle {
  TileEdge edges[3];
  PixelSpan x;
  PixelSpan y;
  bool is_full;            ///< every centre of the window is inside
  std::int32_t primitive;  ///< top bit turned over, as in TileBuffer
  int x_from_ref;          ///< of the tile's first pixel
  int y_from_ref;
};

/// @param window_x, window_y  the pixels that will be looked at; they contain out.x, out.y
/// @return false if no centre of the window is inside
HWY_INLINE bool set_up_edges(const RasterTriangle& t, int left, int top, const PixelSpan& window_x,
                             const PixelSpan& window_y, TileTriangle& out) {
  out.is_full = true;
  for (int i = 0; i < 3; ++i) {
    const WideEdge edge = wide_edge(t, i, left, top);
    const Reach reach = reach_over(edge.step_x, edge.step_y, window_x, window_y);
    if (edge.value + reach.up < 0) return false;
    if (edge.value + reach.down >= 0) {
      out.edges[i] = {0, 0, 0};  // all inside; the numbers themselves may not fit 32 bits
    } else {
      out.is_full = false;
      out.edges[i] = {static_cast<std::int32_t>(edge.value), static_cast<std::int32_t>(edge.step_x),
                      static_cast<std::int32_t>(edge.step_y)};
    }
  }
  return true;
}

/// The plane's bits at one pixel, offsets from the reference pixel.
template <typename Triangle>
HWY_INLINE float depth_at(const Triangle& t, int x_from_ref, int y_from_ref) {
  const float r = (t.r_ref + t.dx * static_cast<float>(x_from_ref)) + t.dy * static_cast<float>(y_from_ref);
  return r < t.lower ? t.lower : (r > t.upper ? t.upper : r);
}
/// The smallest reversed depth over a window; it stands at a corner.
HWY_INLINE float farthest_in(const RasterTriangle& t, const TileTriangle& s) {
  return depth_at(t, s.x_from_ref + (t.dx > 0.0f ? s.x.first : s.x.last),
                  s.y_from_ref + (t.dy > 0.0f ? s.y.first : s.y.last));
}

/// One 8×8 block. @param is_full  every centre is inside: no edge is looked at
template <bool is_full>
HWY_INLINE void draw_block(const TileTriangle& s, const DepthLanes& plane, Int id, int left, int top,
                           TileBuffer& tile) {
  const Int column = lane_column(), row = lane_row();
  Int nearest_of_all = hn::Set(ints, 0x7f800000);
  Int farthest = nearest_of_all;
  for (int strip = 0; strip < strips; ++strip) {
    const int x = left + strip * strip_width;
    const Float fx = hn::ConvertTo(floats, hn::Add(hn::Set(ints, s.x_from_ref + x), column));
    const Float columns = plane.columns(fx);
    Float y = hn::ConvertTo(floats, hn::Add(hn::Set(ints, s.y_from_ref + top), row));
    Int e[3] = {hn::Zero(ints), hn::Zero(ints), hn::Zero(ints)};
    for (int i = 0; i < 3 && !is_full; ++i) {
      const TileEdge& edge = s.edges[i];
      e[i] = hn::Add(
          hn::Set(ints, edge.value + edge.step_x * x + edge.step_y * top),
          hn::Add(hn::Mul(hn::Set(ints, edge.step_x), column), hn::Mul(hn::Set(ints, edge.step_y), row)));
    }
    for (int first = 0; first < block_size; first += rows_at_once) {
      const int at = tile_place(left, top) + first * block_size + strip * strip_width;
      const Int outside = is_full ? hn::Zero(ints) : hn::Or(e[0], hn::Or(e[1], e[2]));
      farthest =
          hn::Min(farthest, merge(plane.bits(columns, y), id, outside, tile.depth + at, tile.primitive + at));
      y = hn::Add(y, hn::Set(floats, static_cast<float>(rows_at_once)));
      for (int i = 0; i < 3 && !is_full; ++i) {
        e[i] = hn::Add(e[i], hn::Set(ints, s.edges[i].step_y * rows_at_once));
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

using RowInts = hn::CappedTag<std::int32_t, blocks_per_tile>;
using RowFloats = hn::RebindToFloat<RowInts>;

HWY_INLINE std::uint32_t bits_of(hn::Mask<RowInts> mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(RowInts(), mask, bits);
  return bits[0];
}

/// Bounds at the corners of all blocks in a row of the tile, several at a time (Greene 1996).
HWY_INLINE BlockRow classify(const RasterTriangle& t, const TileTriangle& s, int top,
                             const TileBuffer& tile) {
  constexpr RowInts d;
  constexpr RowFloats df;
  const int lanes = static_cast<int>(hn::Lanes(d));
  constexpr int reach = block_size - 1;
  const auto zero = hn::Zero(d);
  BlockRow row{0, 0, 0};
  for (int block = 0; block < blocks_per_tile; block += lanes) {
    const auto column = hn::Mul(hn::Add(hn::Iota(d, 0), hn::Set(d, block)), hn::Set(d, block_size));
    auto highest_or = zero;  // negative where one edge has no centre inside
    auto lowest_or = zero;   // negative where one edge has a centre outside
    for (const TileEdge& edge : s.edges) {
      const auto corner =
          hn::Add(hn::Set(d, edge.value + edge.step_y * top), hn::Mul(hn::Set(d, edge.step_x), column));
      const std::int32_t up = (HWY_MAX(edge.step_x, 0) + HWY_MAX(edge.step_y, 0)) * reach;
      const std::int32_t down = (HWY_MIN(edge.step_x, 0) + HWY_MIN(edge.step_y, 0)) * reach;
      highest_or = hn::Or(highest_or, hn::Add(corner, hn::Set(d, up)));
      lowest_or = hn::Or(lowest_or, hn::Add(corner, hn::Set(d, down)));
    }
    const int nearest_x = s.x_from_ref + (t.dx > 0.0f ? reach : 0);
    const int nearest_y = s.y_from_ref + top + (t.dy > 0.0f ? reach : 0);
    const auto fx = hn::ConvertTo(df, hn::Add(column, hn::Set(d, nearest_x)));
    const auto columns = hn::Add(hn::Set(df, t.r_ref), hn::Mul(hn::Set(df, t.dx), fx));
    const auto r = hn::Add(columns, hn::Set(df, t.dy * static_cast<float>(nearest_y)));
    const auto nearest = hn::Min(hn::Max(r, hn::Set(df, t.lower)), hn::Set(df, t.upper));
    const auto farthest = hn::Max(hn::LoadU(df, tile.farthest + top / block_size * blocks_per_tile + block),
                                  hn::Set(df, tile.occluder));
    row.outside |= bits_of(hn::Lt(highest_or, zero)) << block;
    row.full |= bits_of(hn::Not(hn::Lt(lowest_or, zero))) << block;
    row.hidden |= bits_of(hn::Lt(hn::BitCast(d, nearest), hn::BitCast(d, farthest))) << block;
  }
  return row;
}

HWY_INLINE std::uint32_t bits_between(int first, int last) {
  return (2u << last) - (1u << first);
}

HWY_INLINE void draw_blocks(const RasterTriangle& t, const TileTriangle& s, TileBuffer& tile,
                            TileCounts& counts) {
  const DepthLanes plane(t);
  const Int id = hn::Set(ints, s.primitive);
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
        draw_block<true>(s, plane, id, column * block_size, top, tile);
      } else {
        draw_block<false>(s, plane, id, column * block_size, top, tile);
      }
    }
  }
}

/// The triangle's box in the tile. @return false if it holds no centre
HWY_INLINE bool enter_tile(const RasterTriangle& t, int left, int top, const TileBuffer& tile,
                           TileTriangle& out) {
  out.x = covered(t.x, left, tile.width);
  out.y = covered(t.y, top, tile.height);
  out.primitive = static_cast<std::int32_t>(t.primitive ^ 0x80000000u);
  out.x_from_ref = left - t.x_ref;
  out.y_from_ref = top - t.y_ref;
  return out.x.first <= out.x.last && out.y.first <= out.y.last;
}

/// The smallest bound of all blocks of the tile.
HWY_INLINE float farthest_of_all(const TileBuffer& tile) {
  constexpr RowFloats df;
  auto farthest = hn::Load(df, tile.farthest);
  for (int i = static_cast<int>(hn::Lanes(df)); i < blocks_per_tile * blocks_per_tile;
       i += static_cast<int>(hn::Lanes(df))) {
    farthest = hn::Min(farthest, hn::Load(df, tile.farthest + i));
  }
  return hn::GetLane(hn::MinOfLanes(df, farthest));
}

HWY_INLINE void draw_large(const RasterTriangle& t, int left, int top, TileBuffer& tile, TileCounts& counts) {
  TileTriangle s;
  if (!enter_tile(t, left, top, tile, s)) return;
  const PixelSpan window_x{s.x.first & -block_size, s.x.last | (block_size - 1)};
  const PixelSpan window_y{s.y.first & -block_size, s.y.last | (block_size - 1)};
  if (set_up_edges(t, left, top, window_x, window_y, s)) draw_blocks(t, s, tile, counts);
}

HWY_INLINE void raise_occluder(const RasterTriangle& t, int left, int top, TileBuffer& tile) {
  TileTriangle s;
  if (!enter_tile(t, left, top, tile, s)) return;
  if (s.x.first > 0 || s.y.first > 0 || s.x.last < tile.width - 1 || s.y.last < tile.height - 1) return;
  if (!set_up_edges(t, left, top, s.x, s.y, s) || !s.is_full) return;
  const float farthest = farthest_in(t, s);
  if (!(farthest > tile.occluder)) return;
  tile.occluder = farthest;
  tile.has_occluder = true;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
