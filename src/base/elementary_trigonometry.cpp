#include <cmath>

#include "angle_reduction.hpp"
#include "double_bits.hpp"
#include "elementary.hpp"

// Kernels and polynomials: fdlibm (Sun Microsystems 1993), k_sin.c, k_cos.c, s_atan.c, e_asin.c, e_acos.c.
namespace velum::elementary {
namespace {

/// sin(x + tail). @pre |x| ≤ π/4 or a hair more
double sin_kernel(double x, double tail) {
  if (magnitude(x) < 0x1p-27) return x;
  const double z = x * x;
  const double cube = z * x;
  const double rest = 8.33333333332248946124e-03 +
                      z * (-1.98412698298579493134e-04 +
                           z * (2.75573137070700676789e-06 +
                                z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  return x - ((z * (0.5 * tail - cube * rest) - tail) - cube * -1.66666666666666324348e-01);
}

/// cos(x + tail). @pre |x| ≤ π/4 or a hair more
double cos_kernel(double x, double tail) {
  const double z = x * x;
  const double rest =
      z * (4.16666666666666019037e-02 +
           z * (-1.38888888888741095749e-03 +
                z * (2.48015872894767294178e-05 +
                     z * (-2.75573143513906633035e-07 +
                          z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const double half = 0.5 * z;
  const double head = 1.0 - half;
  return head + (((1.0 - head) - half) + (z * rest - x * tail));
}

/// sin of the angle `quadrants` further on.
double sin_of(const ReducedAngle& angle, unsigned quadrants) {
  const double x = angle.remainder.high;
  const double tail = angle.remainder.low;
  const unsigned quadrant = (angle.quadrant + quadrants) & 3u;
  const double value = (quadrant & 1u) == 0 ? sin_kernel(x, tail) : cos_kernel(x, tail);
  return quadrant < 2 ? value : -value;
}

bool is_angle(double x) {
  return magnitude(x) < infinity;
}

/// (asin(x) - x) / x as a function of z = x², for z ≤ ¼.
double asin_rational(double z) {
  const double numerator =
      z * (1.66666666666666657415e-01 +
           z * (-3.25565818622400915405e-01 +
                z * (2.01212532134862925881e-01 +
                     z * (-4.00555345006794114027e-02 +
                          z * (7.91534994289814532176e-04 + z * 3.47933107596021167570e-05)))));
  const double denominator =
      1.0 + z * (-2.40339491173441421878e+00 +
                 z * (2.02094576023350569471e+00 +
                      z * (-6.88283971605453293030e-01 + z * 7.70381505559019352791e-02)));
  return numerator / denominator;
}

constexpr double half_pi_high = 1.57079632679489655800e+00;
constexpr double half_pi_low = 6.12323399573676603587e-17;

/// The upper half of x's bits, so that its square is exact.
double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xffffffff00000000u);
}

/// acos(x) / 2 for ½ ≤ x < 1, as a head whose double is exact and a tail: asin of √((1-x)/2), the
/// half-angle's sine, with that root's own rounding error put back.
DoubleDouble half_acos(double x) {
  const double z = (1.0 - x) * 0.5;
  const double root = std::sqrt(z);
  const double head = upper_half(root);
  const double correction = (z - head * head) / (root + head);
  return {head, asin_rational(z) * root + correction};
}

struct AtanInterval {
  double offset_high;  ///< atan of the interval's centre, as two doubles
  double offset_low;
};

/// (x - atan(x)) / x for |x| ≤ 7/16.
double atan_polynomial(double x) {
  const double z = x * x;
  const double w = z * z;
  const double odd =
      z * (3.33333333333329318027e-01 +
           w * (1.42857142725034663711e-01 +
                w * (9.09088713343650656196e-02 +
                     w * (6.66107313738753120669e-02 +
                          w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
  const double even = w * (-1.99999999998764832476e-01 +
                           w * (-1.11111104054623557880e-01 +
                                w * (-7.69187620504482999495e-02 +
                                     w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));
  return odd + even;
}

/// atan(x) for x > 7/16: atan(c) + atan((x - c) / (1 + c·x)) for c = ½, 1, 3/2, infinity.
double atan_beyond(double x) {
  AtanInterval interval{};
  double reduced = 0.0;
  if (x < 11.0 / 16.0) {
    interval = {4.63647609000806093515e-01, 2.26987774529616870924e-17};
    reduced = (2.0 * x - 1.0) / (2.0 + x);
  } else if (x < 19.0 / 16.0) {
    interval = {7.85398163397448278999e-01, 3.06161699786838301793e-17};
    reduced = (x - 1.0) / (x + 1.0);
  } else if (x < 39.0 / 16.0) {
    interval = {9.82793723247329054082e-01, 1.39033110312309984516e-17};
    reduced = (x - 1.5) / (1.0 + 1.5 * x);
  } else {
    interval = {half_pi_high, half_pi_low};
    reduced = -1.0 / x;
  }
  return interval.offset_high - ((reduced * atan_polynomial(reduced) - interval.offset_low) - reduced);
}

}  // namespace

double sin(double x) {
  if (!is_angle(x)) return not_a_number;
  return sin_of(reduce_angle(x), 0);
}

double cos(double x) {
  if (!is_angle(x)) return not_a_number;
  return sin_of(reduce_angle(x), 1);
}

double tan(double x) {
  if (!is_angle(x)) return not_a_number;
  const ReducedAngle angle = reduce_angle(x);
  return sin_of(angle, 0) / sin_of(angle, 1);
}

double asin(double x) {
  const double size = magnitude(x);
  if (!(size <= 1.0)) return not_a_number;
  if (size < 0x1p-27) return x;
  if (size < 0.5) return x + x * asin_rational(x * x);
  if (size == 1.0) return with_sign_of(half_pi_high, x);
  // π/4 - (tail - (π/4 - head)): the large parts first, exactly.
  constexpr double quarter_pi = 0.5 * half_pi_high;
  const DoubleDouble half = half_acos(size);
  const double rest = (2.0 * half.low - half_pi_low) - (quarter_pi - 2.0 * half.high);
  return with_sign_of(quarter_pi - rest, x);
}

double acos(double x) {
  if (!(magnitude(x) <= 1.0)) return not_a_number;
  if (x == 1.0) return 0.0;
  if (x == -1.0) return 2.0 * half_pi_high;
  if (x >= 0.5) {
    const DoubleDouble half = half_acos(x);
    return 2.0 * (half.high + half.low);
  }
  if (x > -0.5) return half_pi_high - (x - (half_pi_low - x * asin_rational(x * x)));
  // Here √((1+x)/2) is the sine of the half-angle's complement, and its error too small to matter.
  const double z = (1.0 + x) * 0.5;
  const double root = std::sqrt(z);
  return 2.0 * (half_pi_high - (root + (asin_rational(z) * root - half_pi_low)));
}

double atan(double x) {
  if (is_nan(x)) return x;
  const double size = magnitude(x);
  if (size < 0x1p-27) return x;
  if (size <= 7.0 / 16.0) return x - x * atan_polynomial(x);
  return with_sign_of(atan_beyond(size), x);
}

double atan2(double y, double x) {
  if (is_nan(x) || is_nan(y)) return not_a_number;
  double ratio = magnitude(y) / magnitude(x);
  if (is_nan(ratio))
    ratio = y == 0.0 ? 0.0 : 1.0;  // 0/0 lies on the x axis; infinity/infinity on the diagonal
  const double angle = atan(ratio);
  const double from_positive_x = is_negative(x) ? 2.0 * half_pi_high - (angle - 2.0 * half_pi_low) : angle;
  return with_sign_of(from_positive_x, y);
}

}  // namespace velum::elementary
