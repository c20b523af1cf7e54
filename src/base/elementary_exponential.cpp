#include <array>

#include "double_bits.hpp"
#include "double_double.hpp"
#include "elementary.hpp"

// Reductions and polynomials of exp and log: fdlibm (Sun Microsystems 1993), e_exp.c, e_log.c.
namespace velum::elementary {
namespace {

// ln 2 as a sum whose first part has 21 trailing zero bits: times an exponent it is exact.
constexpr double ln2_high = 6.93147180369123816490e-01;
constexpr double ln2_low = 1.90821492927058770002e-10;
constexpr DoubleDouble ln2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

/// e^(x + tail). @param tail |tail| ≤ ulp(x)
double exp_with_tail(double x, double tail) {
  if (x > 710.0) return infinity;
  if (x < -746.0) return 0.0;
  const int k = static_cast<int>(x * 1.44269504088896338700 + (x < 0.0 ? -0.5 : 0.5));
  const double high = x - static_cast<double>(k) * ln2_high;
  const double low = static_cast<double>(k) * ln2_low - tail;

  // e^r = 1 + r + r·c/(2 - c) with c an even polynomial away from r.
  const double r = high - low;
  const double z = r * r;
  const double c = r - z * (1.66666666666666019037e-01 +
                            z * (-2.77777777770155933842e-03 +
                                 z * (6.61375632143793436117e-05 +
                                      z * (-1.65339022054652515390e-06 + z * 4.13813679705723846039e-08))));
  return scale(1.0 - ((low - (r * c) / (2.0 - c)) - high), k);
}

/// Σ z^k / (2k + 7), k = 0 … 10: what follows z²/5 in the series of artanh, divided by z³.
double artanh_tail(double z) {
  double sum = 1.0 / 27.0;
  for (int denominator = 25; denominator >= 7; denominator -= 2) sum = 1.0 / denominator + z * sum;
  return sum;
}

/// log x with a relative error below 2^-64: 2·artanh((m - 1)/(m + 1)) + k·ln 2.
/// @pre 0 < x < infinity
DoubleDouble log_extended(double x) {
  constexpr DoubleDouble third = {0x1.5555555555555p-2, 0x1.5555555555555p-56};
  constexpr DoubleDouble fifth = {0x1.999999999999ap-3, -0x1.999999999999ap-57};
  const Scaled scaled = split_around_one(x);
  const DoubleDouble s = divide(scaled.significand - 1.0, two_sum(scaled.significand, 1.0));
  const DoubleDouble z = multiply(s, s);
  DoubleDouble series = add(fifth, {z.high * artanh_tail(z.high), 0.0});
  series = add(third, multiply(z, series));
  series = add({1.0, 0.0}, multiply(z, series));
  const DoubleDouble log_significand = multiply(s, series);
  return add(multiply(ln2, static_cast<double>(scaled.exponent)),
             {2.0 * log_significand.high, 2.0 * log_significand.low});
}

enum class Parity { fractional, even, odd };

Parity parity(double y) {
  const double size = magnitude(y);
  if (size >= 0x1p53) return Parity::even;
  if (floor(size) != size) return Parity::fractional;
  return (static_cast<std::uint64_t>(size) & 1u) == 0 ? Parity::even : Parity::odd;
}

/// |x|^y. @pre x > 0 or infinite or 0; y neither 0 nor NaN; |x| not 1
double pow_of_magnitude(double size, double y) {
  const bool grows = (size > 1.0) == (y > 0.0);
  if (size == 0.0 || size == infinity || magnitude(y) == infinity) return grows ? infinity : 0.0;
  // |log x| is between 2^-53 and 2^10: beyond these y the answer is known, within them nothing below
  // overflows.
  if (magnitude(y) > 0x1p64) return grows ? infinity : 0.0;
  if (magnitude(y) < 0x1p-70) return 1.0;
  const DoubleDouble exponent = multiply(log_extended(size), y);
  return exp_with_tail(exponent.high, exponent.low);
}

}  // namespace

double exp(double x) {
  return is_nan(x) ? x : exp_with_tail(x, 0.0);
}

double log(double x) {
  if (is_nan(x) || x == infinity) return x;
  if (x == 0.0) return -infinity;
  if (x < 0.0) return not_a_number;
  const Scaled scaled = split_around_one(x);
  const double k = static_cast<double>(scaled.exponent);

  // log(1 + f) = f - f²/2 + s·(f²/2 + R), s = f/(2 + f), R an even polynomial of s.
  const double f = scaled.significand - 1.0;
  const double s = f / (2.0 + f);
  const double z = s * s;
  const double rest =
      z * (6.666666666666735130e-01 +
           z * (3.999999999940941908e-01 +
                z * (2.857142874366239149e-01 +
                     z * (2.222219843214978396e-01 +
                          z * (1.818357216161805012e-01 +
                               z * (1.531383769920937332e-01 + z * 1.479819860510658591e-01))))));
  const double half_square = 0.5 * f * f;
  return k * ln2_high - ((half_square - (s * (half_square + rest) + k * ln2_low)) - f);
}

double pow(double x, double y) {
  if (y == 0.0 || x == 1.0) return 1.0;
  if (is_nan(x) || is_nan(y)) return not_a_number;
  const Parity kind = parity(y);
  if (x < 0.0 && x > -infinity && kind == Parity::fractional) return not_a_number;
  const double size = magnitude(x);
  const double value = size == 1.0 ? 1.0 : pow_of_magnitude(size, y);
  return kind == Parity::odd && is_negative(x) ? -value : value;
}

}  // namespace velum::elementary
