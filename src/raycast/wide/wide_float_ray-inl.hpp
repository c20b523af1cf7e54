// Rays in float32, so that they miss no box. Highway reads this file once per instruction set, so its guard
// turns with the target.
#if defined(VELUM_WIDE_FLOAT_RAY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_FLOAT_RAY_INL
#undef VELUM_WIDE_FLOAT_RAY_INL
#else
#define VELUM_WIDE_FLOAT_RAY_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// Within these for origin, direction and reach, nothing overflows, and what underflows is far below the
/// margins.
constexpr float smallest_float = 0x1p-50f, largest_float = 0x1p50f;
/// No inverse of a direction is larger: along an axis in which a ray moves by less than 2^-100 per unit of t,
/// it stays within the margin.
constexpr float largest_inverse = 0x1p100f;

HWY_INLINE float larger(float a, float b) {
  return a > b ? a : b;
}
HWY_INLINE float smaller(float a, float b) {
  return a < b ? a : b;
}
HWY_INLINE float size_of(float v) {
  return __builtin_fabsf(v);
}
HWY_INLINE double size_of(double v) {
  return __builtin_fabs(v);
}

/// A float32 that is not smaller; at most about 1e38.
HWY_INLINE float not_below(double v) {
  constexpr double largest = 1e38;
  const double bounded = v > largest ? largest : (v > -largest ? v : -largest);
  const float f = static_cast<float>(bounded);
  return f + (size_of(f) * 0x1p-23f + 0x1p-126f);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
