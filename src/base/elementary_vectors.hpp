/// For kernel files: vector versions of elementary functions, the same bits as the scalar ones lane by lane,
/// operation for operation. Read anew for every instruction set, so without `#pragma once`.
#if defined(VELUM_ELEMENTARY_VECTORS_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_ELEMENTARY_VECTORS_HPP
#undef VELUM_ELEMENTARY_VECTORS_HPP
#else
#define VELUM_ELEMENTARY_VECTORS_HPP
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "elementary.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace elementary_vectors {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using Double = hn::Vec<Doubles>;
using Bits = hn::RebindToUnsigned<Doubles>;
using SignedBits = hn::RebindToSigned<Doubles>;
using Ints = hn::Rebind<std::int32_t, Doubles>;
constexpr Doubles doubles;
constexpr Bits bits;
constexpr SignedBits signed_bits;
constexpr Ints ints;

HWY_INLINE Double all(double value) {
  return hn::Set(doubles, value);
}
HWY_INLINE Double sum(Double a, Double b) {
  return hn::Add(a, b);
}
HWY_INLINE Double difference(Double a, Double b) {
  return hn::Sub(a, b);
}
HWY_INLINE Double product(Double a, Double b) {
  return hn::Mul(a, b);
}

/// DoubleDouble and its operations: see double_double.hpp.
struct DoubleDoubles {
  Double high;
  Double low;
};

HWY_INLINE DoubleDoubles quick_two_sum(Double a, Double b) {
  const Double s = sum(a, b);
  return {s, difference(b, difference(s, a))};
}
HWY_INLINE DoubleDoubles two_sum(Double a, Double b) {
  const Double s = sum(a, b);
  const Double b_part = difference(s, a);
  return {s, sum(difference(a, difference(s, b_part)), difference(b, b_part))};
}
HWY_INLINE DoubleDoubles split(Double a) {
  const Double shifted = product(a, all(134217729.0));
  const Double high = difference(shifted, difference(shifted, a));
  return {high, difference(a, high)};
}
HWY_INLINE DoubleDoubles two_product(Double a, Double b) {
  const Double p = product(a, b);
  const DoubleDoubles x = split(a);
  const DoubleDoubles y = split(b);
  const Double first = sum(difference(product(x.high, y.high), p), product(x.high, y.low));
  return {p, sum(sum(first, product(x.low, y.high)), product(x.low, y.low))};
}
HWY_INLINE DoubleDoubles add(const DoubleDoubles& a, const DoubleDoubles& b) {
  const DoubleDoubles s = two_sum(a.high, b.high);
  return quick_two_sum(s.high, sum(s.low, sum(a.low, b.low)));
}
HWY_INLINE DoubleDoubles multiply(const DoubleDoubles& a, const DoubleDoubles& b) {
  const DoubleDoubles p = two_product(a.high, b.high);
  return quick_two_sum(p.high, sum(p.low, sum(product(a.high, b.low), product(a.low, b.high))));
}
HWY_INLINE DoubleDoubles multiply(const DoubleDoubles& a, Double b) {
  const DoubleDoubles p = two_product(a.high, b);
  return quick_two_sum(p.high, sum(p.low, product(a.low, b)));
}
HWY_INLINE DoubleDoubles divide(Double a, const DoubleDoubles& b) {
  const Double quotient = hn::Div(a, b.high);
  const DoubleDoubles p = two_product(quotient, b.high);
  const Double remainder = difference(difference(difference(a, p.high), p.low), product(quotient, b.low));
  return quick_two_sum(quotient, hn::Div(remainder, b.high));
}

struct Scaled {
  Double significand;
  Double exponent;  ///< a whole number
};

/// split_around_one() of positive normal numbers.
HWY_INLINE Scaled split_around_one(Double x) {
  const auto pattern = hn::BitCast(bits, x);
  // The exponent's bits in the last places of 2^52: that many more.
  const auto counted = hn::Or(hn::ShiftRight<52>(pattern), hn::Set(bits, 0x4330000000000000u));
  const Double exponent = difference(hn::BitCast(doubles, counted), all(0x1p52 + 1023.0));
  const auto fraction = hn::And(pattern, hn::Set(bits, 0x000fffffffffffffu));
  const Double one_to_two = hn::BitCast(doubles, hn::Or(fraction, hn::Set(bits, 0x3ff0000000000000u)));
  const auto is_low = hn::Lt(one_to_two, all(1.4142135623730951));
  return {hn::IfThenElse(is_low, one_to_two, product(one_to_two, all(0.5))),
          hn::IfThenElse(is_low, exponent, sum(exponent, all(1.0)))};
}

HWY_INLINE Double artanh_tail(Double z) {
  Double s = all(1.0 / 27.0);
  for (int denominator = 25; denominator >= 7; denominator -= 2)
    s = sum(all(1.0 / denominator), product(z, s));
  return s;
}

/// log_extended() of positive normal numbers.
HWY_INLINE DoubleDoubles log_extended(Double x) {
  const Double zero = hn::Zero(doubles), one = all(1.0), two = all(2.0);
  const DoubleDoubles third = {all(0x1.5555555555555p-2), all(0x1.5555555555555p-56)};
  const DoubleDoubles fifth = {all(0x1.999999999999ap-3), all(-0x1.999999999999ap-57)};
  const DoubleDoubles ln2 = {all(0x1.62e42fefa39efp-1), all(0x1.abc9e3b39803fp-56)};
  const Scaled scaled = split_around_one(x);
  const DoubleDoubles s = divide(difference(scaled.significand, one), two_sum(scaled.significand, one));
  const DoubleDoubles z = multiply(s, s);
  DoubleDoubles series = add(fifth, {product(z.high, artanh_tail(z.high)), zero});
  series = add(third, multiply(z, series));
  series = add({one, zero}, multiply(z, series));
  const DoubleDoubles log_significand = multiply(s, series);
  return add(multiply(ln2, scaled.exponent),
             {product(two, log_significand.high), product(two, log_significand.low)});
}

/// elementary::log() of positive normal numbers.
HWY_INLINE Double log(Double x) {
  const Scaled scaled = split_around_one(x);
  const Double f = difference(scaled.significand, all(1.0));
  const Double s = hn::Div(f, sum(all(2.0), f));
  const Double z = product(s, s);
  Double rest = all(1.479819860510658591e-01);
  for (const double coefficient :
       {1.531383769920937332e-01, 1.818357216161805012e-01, 2.222219843214978396e-01,
        2.857142874366239149e-01, 3.999999999940941908e-01, 6.666666666666735130e-01})
    rest = sum(all(coefficient), product(z, rest));
  const Double half_square = product(product(all(0.5), f), f);
  const Double low = sum(product(s, sum(half_square, product(z, rest))),
                         product(scaled.exponent, all(1.90821492927058770002e-10)));
  return difference(product(scaled.exponent, all(6.93147180369123816490e-01)),
                    difference(difference(half_square, low), f));
}

HWY_INLINE Double power_of_two(hn::Vec<Ints> exponent) {
  const auto biased = hn::Add(hn::PromoteTo(signed_bits, exponent), hn::Set(signed_bits, 1023));
  return hn::BitCast(doubles, hn::ShiftLeft<52>(biased));
}

/// scale(): x · 2^exponent, rounded once.
HWY_INLINE Double scale(Double x, hn::Vec<Ints> exponent) {
  const auto is_high = hn::Gt(exponent, hn::Set(ints, 1023));
  const auto is_low = hn::Lt(exponent, hn::Set(ints, -1000));
  const auto up = hn::IfThenElseZero(is_low, hn::Set(ints, 1000));
  const auto down = hn::IfThenElseZero(is_high, hn::Set(ints, 1));
  const Double k = hn::PromoteTo(doubles, exponent);
  const Double doubled = hn::IfThenElse(hn::Gt(k, all(1023.0)), product(x, all(2.0)), x);
  const Double scaled = product(doubled, power_of_two(hn::Sub(hn::Add(exponent, up), down)));
  return hn::IfThenElse(hn::Lt(k, all(-1000.0)), product(scaled, all(0x1p-1000)), scaled);
}

/// exp_with_tail(). @pre not NaN
HWY_INLINE Double exp_with_tail(Double x, Double tail) {
  const Double half = hn::IfThenElse(hn::Lt(x, hn::Zero(doubles)), all(-0.5), all(0.5));
  const auto k = hn::DemoteTo(ints, sum(product(x, all(1.44269504088896338700)), half));
  const Double whole = hn::PromoteTo(doubles, k);
  const Double high = difference(x, product(whole, all(6.93147180369123816490e-01)));
  const Double low = difference(product(whole, all(1.90821492927058770002e-10)), tail);
  const Double r = difference(high, low);
  const Double z = product(r, r);
  Double rest = all(4.13813679705723846039e-08);
  for (const double coefficient : {-1.65339022054652515390e-06, 6.61375632143793436117e-05,
                                   -2.77777777770155933842e-03, 1.66666666666666019037e-01})
    rest = sum(all(coefficient), product(z, rest));
  const Double c = difference(r, product(z, rest));
  const Double quotient = hn::Div(product(r, c), difference(all(2.0), c));
  const Double value = difference(all(1.0), difference(difference(low, quotient), high));
  const Double scaled = scale(value, k);
  const Double infinity = hn::BitCast(doubles, hn::Set(bits, 0x7ff0000000000000u));
  const Double not_small = hn::IfThenZeroElse(hn::Lt(x, all(-746.0)), scaled);
  return hn::IfThenElse(hn::Gt(x, all(710.0)), infinity, not_small);
}

/// elementary::pow(). Lanes whose x is not a positive normal number, or whose y is extremely large or small,
/// are left to it.
HWY_INLINE Double pow(Double x, Double y) {
  const Double size = hn::Abs(y);
  const auto is_common_x = hn::And(hn::Ge(x, all(0x1p-1022)), hn::Le(x, all(hwy::HighestValue<double>())));
  const auto is_common_y = hn::And(hn::Ge(size, all(0x1p-70)), hn::Le(size, all(0x1p64)));
  if (hn::AllTrue(doubles, hn::And(is_common_x, is_common_y))) {
    const DoubleDoubles exponent = multiply(log_extended(x), y);
    return exp_with_tail(exponent.high, exponent.low);
  }
  HWY_ALIGN double base[hn::MaxLanes(doubles)];
  HWY_ALIGN double power[hn::MaxLanes(doubles)];
  hn::Store(x, doubles, base);
  hn::Store(y, doubles, power);
  for (std::size_t i = 0; i < hn::Lanes(doubles); ++i) base[i] = elementary::pow(base[i], power[i]);
  return hn::Load(doubles, base);
}

}  // namespace elementary_vectors
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
