// One ray against eight boxes. Highway reads this file once per instruction set, so its guard turns with the
// target.
#if defined(VELUM_WIDE_BOX_RAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_BOX_RAY_INL
#undef VELUM_WIDE_BOX_RAY_INL
#else
#define VELUM_WIDE_BOX_RAY_INL
#endif

#include <hwy/highway.h>

#include "wide_cast_kernels.hpp"
#include "wide_float_ray-inl.hpp"
#include "wide_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// The ray's numbers in every lane; t is not scaled.
///
/// An interval that is computed from them holds the interval that PreparedRay::through() gives for the same
/// box in double: the margin, 2^-20 of the reach and 2^-22 of the origin, is more than the rounding of the
/// origin (2^-24 of it), of the reach, the difference, the direction, the inverse and the product (2^-24 of
/// the reach each).
struct BoxRay {
  hn::Vec<Boxes> near_from[3], far_from[3], inverse[3], lower;
  std::size_t near_row[3], far_row[3];
  float upper;
  bool is_usable;  ///< false: numbers are too large or too small

  // One axis after the other: what is computed side by side waits for its slowest part, and every ray waits
  // for this.
  HWY_INLINE explicit BoxRay(const WideQuery& query)
      : lower(hn::Set(boxes, -not_below(-query.lower))), upper(not_below(query.upper)) {
    float origin[3], direction[3];
    float reach = 0.0f, speed = 0.0f, sum = 0.0f, farthest = 0.0f;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      origin[axis] = static_cast<float>(query.origin[axis]);
      direction[axis] = static_cast<float>(query.direction[axis]);
      const float to_upper = query.bounds->upper[axis] - origin[axis];
      const float to_lower = origin[axis] - query.bounds->lower[axis];
      reach = larger(reach, larger(to_upper, to_lower));
      farthest = larger(farthest, size_of(origin[axis]));
      speed = larger(speed, size_of(direction[axis]));
      sum += origin[axis] + direction[axis];
    }
    // The sum finds what is not a number.
    is_usable = (reach > smallest_float) & (larger(reach, farthest) < largest_float) &
                (speed > smallest_float) & (speed < largest_float) & (sum < 8.0f * largest_float);
    for (std::size_t axis = 0; axis < 3; ++axis) set_axis(axis, origin[axis], direction[axis], reach);
  }
  /// Where the ray meets the sides of boxes that it enters, or leaves, through.
  HWY_INLINE hn::Vec<Boxes> near(const WideNode& node, std::size_t axis, std::size_t first) const {
    const auto side = hn::Load(boxes, node.bounds[near_row[axis]] + first);
    return hn::Mul(hn::Sub(side, near_from[axis]), inverse[axis]);
  }
  HWY_INLINE hn::Vec<Boxes> far(const WideNode& node, std::size_t axis, std::size_t first) const {
    const auto side = hn::Load(boxes, node.bounds[far_row[axis]] + first);
    return hn::Mul(hn::Sub(side, far_from[axis]), inverse[axis]);
  }

 private:
  HWY_INLINE void set_axis(std::size_t axis, float origin, float direction, float reach) {
    const float bounded = smaller(larger(1.0f / direction, -largest_inverse), largest_inverse);
    const float margin = 0x1p-20f * reach + 0x1p-22f * size_of(origin);
    const float forwards = __builtin_copysignf(margin, bounded);
    const auto is_back = static_cast<std::size_t>(bounded < 0.0f);
    near_from[axis] = hn::Set(boxes, origin + forwards);
    far_from[axis] = hn::Set(boxes, origin - forwards);
    inverse[axis] = hn::Set(boxes, bounded);
    near_row[axis] = axis + 3 * is_back;
    far_row[axis] = axis + 3 - 3 * is_back;
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
