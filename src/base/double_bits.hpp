#pragma once

#include <bit>
#include <cstdint>
#include <limits>

/// The parts of a double's bit pattern, for the elementary functions: no libm calls (not even fabs).
namespace velum::elementary {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr std::uint64_t sign_bit = 0x8000000000000000u;

inline bool is_nan(double x) {
  return x != x;
}
/// True for NaN with the sign bit too, and for -0.
inline bool is_negative(double x) {
  return (std::bit_cast<std::uint64_t>(x) & sign_bit) != 0;
}
inline double magnitude(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~sign_bit);
}
inline double with_sign_of(double x, double sign) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) & ~sign_bit;
  return std::bit_cast<double>(bits | (std::bit_cast<std::uint64_t>(sign) & sign_bit));
}
/// @pre -1022 ≤ exponent ≤ 1023
inline double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// x = significand · 2^exponent with the given interval of the significand; exact.
struct Scaled {
  double significand;
  int exponent;
};

/// Splits x so that the significand is in [√½, √2) or a hair beyond, close around 1 as log needs it.
/// @pre 0 < x < infinity
inline Scaled split_around_one(double x) {
  int exponent = 0;
  if (x < 0x1p-1022) {
    x *= 0x1p54;
    exponent = -54;
  }
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  exponent += static_cast<int>(bits >> 52) - 1023;
  const double one_to_two = std::bit_cast<double>((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);
  if (one_to_two < 1.4142135623730951) return {one_to_two, exponent};
  return {one_to_two * 0.5, exponent + 1};
}

/// x · 2^exponent, rounded once. @pre ½ ≤ x ≤ 2, -1100 ≤ exponent ≤ 1024
inline double scale(double x, int exponent) {
  if (exponent > 1023) return x * 2.0 * power_of_two(exponent - 1);
  if (exponent < -1000) return x * power_of_two(exponent + 1000) * 0x1p-1000;
  return x * power_of_two(exponent);
}

}  // namespace velum::elementary
