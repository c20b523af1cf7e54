// Boxes, areas and edge functions of small triangles, in integers; see set_up_simd.cpp.
#if defined(VELUM_SET_UP_EDGES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_SET_UP_EDGES_INL
#undef VELUM_SET_UP_EDGES_INL
#else
#define VELUM_SET_UP_EDGES_INL
#endif

#include "set_up_chunk-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// Pixels whose centres lie in the triangles' boxes and in the target, ends included.
struct CentreBox {
  Int left, top, right, bottom;
};

HWY_INLINE Int lowest(const Int (&v)[3]) {
  return hn::Min(v[0], hn::Min(v[1], v[2]));
}
HWY_INLINE Int highest(const Int (&v)[3]) {
  return hn::Max(v[0], hn::Max(v[1], v[2]));
}

HWY_INLINE CentreBox centre_box(const SetUpWork& work, const TriangleLanes& t) {
  const Int before = hn::Set(ints, 127), half = hn::Set(ints, 128);
  return {hn::Max(hn::ShiftRight<8>(hn::Add(lowest(t.x), before)), hn::Set(ints, work.target_left)),
          hn::Max(hn::ShiftRight<8>(hn::Add(lowest(t.y), before)), hn::Set(ints, work.target_top)),
          hn::Min(hn::ShiftRight<8>(hn::Sub(highest(t.x), half)), hn::Set(ints, work.target_right - 1)),
          hn::Min(hn::ShiftRight<8>(hn::Sub(highest(t.y), half)), hn::Set(ints, work.target_bottom - 1))};
}

/// doubled_area() where is_small() holds.
struct AreaLanes {
  Int area;
  IntMask is_small;
};
HWY_INLINE AreaLanes area_of(const TriangleLanes& t) {
  const Int x1 = hn::Sub(t.x[1], t.x[0]), x2 = hn::Sub(t.x[2], t.x[0]);
  const Int y1 = hn::Sub(t.y[1], t.y[0]), y2 = hn::Sub(t.y[2], t.y[0]);
  const Int limit = hn::Set(ints, small_extent);
  const IntMask is_short = hn::And(hn::Lt(hn::Sub(highest(t.x), lowest(t.x)), limit),
                                   hn::Lt(hn::Sub(highest(t.y), lowest(t.y)), limit));
  const Int area = hn::Sub(hn::Mul(x1, y2), hn::Mul(y1, x2));
  const Int turn = hn::Add(hn::Add(hn::Abs(x1), hn::Abs(y1)), hn::Add(hn::Abs(x2), hn::Abs(y2)));
  const IntMask is_sure = hn::Gt(hn::Abs(area), hn::Add(turn, hn::Set(ints, turned_margin)));
  return {area, hn::And(is_short, is_sure)};
}

/// The edge functions of SmallTriangle.
struct EdgeLanes {
  Int value[3], step_x[3], step_y[3];
};
HWY_INLINE EdgeLanes edges_of(const TriangleLanes& t, const CentreBox& box) {
  const Int half = hn::Set(ints, 128), zero = hn::Zero(ints);
  const Int centre_x = hn::Add(hn::ShiftLeft<8>(box.left), half);
  const Int centre_y = hn::Add(hn::ShiftLeft<8>(box.top), half);
  EdgeLanes edges;
  for (int from = 0; from < 3; ++from) {
    const int to = from == 2 ? 0 : from + 1;
    const Int dx = hn::Sub(t.x[to], t.x[from]), dy = hn::Sub(t.y[to], t.y[from]);
    const Int value =
        hn::Sub(hn::Mul(dx, hn::Sub(centre_y, t.y[from])), hn::Mul(dy, hn::Sub(centre_x, t.x[from])));
    const IntMask owns_its_points = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Gt(dx, zero)));
    const Int less = hn::IfThenZeroElse(owns_its_points, hn::Set(ints, 1));
    edges.value[from] = hn::ShiftRight<8>(hn::Sub(value, less));
    edges.step_x[from] = hn::Neg(dy);
    edges.step_y[from] = dx;
  }
  return edges;
}

/// Turns the triangles clockwise.
HWY_INLINE TriangleLanes clockwise(const TriangleLanes& t, Int area) {
  const IntMask turned = hn::Lt(area, hn::Zero(ints));
  return {{t.x[0], hn::IfThenElse(turned, t.x[2], t.x[1]), hn::IfThenElse(turned, t.x[1], t.x[2])},
          {t.y[0], hn::IfThenElse(turned, t.y[2], t.y[1]), hn::IfThenElse(turned, t.y[1], t.y[2])}};
}

HWY_INLINE Int packed_shorts(Int low, Int high) {
  return hn::Or(hn::And(low, hn::Set(ints, 0xFFFF)), hn::ShiftLeft<16>(high));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
