// What the kernels of the tile raster share. Highway reads this file once per instruction set, so its guard
// turns with the target.
#if defined(VELUM_TILE_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_TILE_LANES_INL
#undef VELUM_TILE_LANES_INL
#else
#define VELUM_TILE_LANES_INL
#endif

#include <hwy/highway.h>

#include "tile_buffer.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Ints = hn::CappedTag<std::int32_t, 16>;
using Floats = hn::RebindToFloat<Ints>;
using Int = hn::Vec<Ints>;
using Float = hn::Vec<Floats>;
constexpr Ints ints;
constexpr Floats floats;

/// A vector holds one or two rows of a block, or part of one: a block is drawn in `strips` of `strip_width`
/// columns, `rows_at_once` rows at a time.
constexpr int lane_count = static_cast<int>(hn::MaxLanes(ints));
constexpr int strip_width = lane_count < block_size ? lane_count : block_size;
constexpr int strips = block_size / strip_width;
constexpr int rows_at_once = lane_count / strip_width;

/// Column and row of each lane within the strip.
HWY_INLINE Int lane_column() {
  return hn::And(hn::Iota(ints, 0), hn::Set(ints, strip_width - 1));
}
HWY_INLINE Int lane_row() {
  if (rows_at_once == 1) return hn::Zero(ints);
  return hn::ShiftRight<3>(hn::Iota(ints, 0));
}

/// The depth plane of a triangle in every lane.
struct DepthLanes {
  Float r_ref, dx, dy, lower, upper;

  template <typename Triangle>
  HWY_INLINE explicit DepthLanes(const Triangle& t)
      : r_ref(hn::Set(floats, t.r_ref)),
        dx(hn::Set(floats, t.dx)),
        dy(hn::Set(floats, t.dy)),
        lower(hn::Set(floats, t.lower)),
        upper(hn::Set(floats, t.upper)) {}

  /// r_ref + dx·x. @param x  pixels from x_ref
  HWY_INLINE Float columns(Float x) const { return hn::Add(r_ref, hn::Mul(dx, x)); }
  /// The bits of DepthPlane::at. @param y  pixels from y_ref
  HWY_INLINE Int bits(Float columns_there, Float y) const {
    const Float r = hn::Max(hn::Add(columns_there, hn::Mul(dy, y)), lower);
    return hn::BitCast(ints, hn::Min(r, upper));
  }
};

/// Keeps the nearer, lane by lane: r > buffer, or r = buffer and the smaller id; only where `outside` is not
/// negative. As integers; depths are never negative.
/// @return the depths that stand there now
HWY_INLINE Int merge(Int r, Int id, Int outside, std::int32_t* depth, std::int32_t* primitive) {
  const Int old_r = hn::Load(ints, depth);
  const Int old_id = hn::Load(ints, primitive);
  const Int sign = hn::Set(ints, INT32_MIN);
  const Int r_inside = hn::Or(r, hn::And(outside, sign));  // negative outside: nearer than nothing
  const Int wins_ties = hn::VecFromMask(ints, hn::Gt(old_id, id));
  const auto wins = hn::Gt(r_inside, hn::Add(old_r, wins_ties));
  const Int new_r = hn::Max(old_r, r_inside);
  hn::Store(new_r, ints, depth);
  hn::Store(hn::IfThenElse(wins, id, old_id), ints, primitive);
  return new_r;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
