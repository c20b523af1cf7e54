// clip_position() of stages.hpp, lane by lane.
#if defined(VELUM_CLIP_POSITION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_CLIP_POSITION_INL
#undef VELUM_CLIP_POSITION_INL
#else
#define VELUM_CLIP_POSITION_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using NarrowFloats = hn::Rebind<float, Doubles>;
using NarrowInts = hn::Rebind<std::int32_t, Doubles>;
using Double = hn::Vec<Doubles>;
using Mask = hn::Mask<Doubles>;
constexpr Doubles doubles;
constexpr NarrowFloats narrow_floats;
constexpr NarrowInts narrow_ints;

struct ClipVector {
  Double x, y, z, w;
};

/// Component `row` of ((m0·x + m1·y) + m2·z) + m3.
HWY_INLINE Double row_of(const double* m, int row, Double x, Double y, Double z) {
  const Double sum = hn::Add(hn::Mul(hn::Set(doubles, m[row]), x), hn::Mul(hn::Set(doubles, m[4 + row]), y));
  return hn::Add(hn::Add(sum, hn::Mul(hn::Set(doubles, m[8 + row]), z)), hn::Set(doubles, m[12 + row]));
}

/// @param m  clip_from_object, column by column
HWY_INLINE ClipVector clip_position(const double* m, hn::Vec<NarrowFloats> px, hn::Vec<NarrowFloats> py,
                                    hn::Vec<NarrowFloats> pz) {
  const Double x = hn::PromoteTo(doubles, px), y = hn::PromoteTo(doubles, py), z = hn::PromoteTo(doubles, pz);
  return {row_of(m, 0, x, y, z), row_of(m, 1, x, y, z), row_of(m, 2, x, y, z), row_of(m, 3, x, y, z)};
}

/// r kept in [0, 1]; 0 for no number.
HWY_INLINE Double unit(Double r) {
  const Double one = hn::Set(doubles, 1.0);
  return hn::IfThenElseZero(hn::Gt(r, hn::Zero(doubles)), hn::IfThenElse(hn::Lt(r, one), r, one));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
