#include "angle_reduction.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "double_bits.hpp"

namespace velum::elementary {
namespace {

/// 2/π = 0.a2f9836e4e44…, 32 bits each: word i has the weight 2^(-32(i+1)).
constexpr std::array<std::uint32_t, 38> two_over_pi = {
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab,
};

constexpr int used_words = 7;
constexpr DoubleDouble half_pi = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// Little-endian: word i has the weight 2^(32i).
using Product = std::array<std::uint32_t, used_words + 2>;

/// mantissa · the words of 2/π from `first` on.
Product multiply_words(std::uint64_t mantissa, int first) {
  Product product{};
  for (int half = 0; half < 2; ++half) {
    const std::uint64_t factor = half == 0 ? mantissa & 0xffffffffu : mantissa >> 32;
    std::uint64_t carry = 0;
    for (int i = 0; i < used_words; ++i) {
      const std::uint64_t word = two_over_pi[static_cast<std::size_t>(first + used_words - 1 - i)];
      std::uint32_t& slot = product[static_cast<std::size_t>(i + half)];
      const std::uint64_t sum = factor * word + slot + carry;
      slot = static_cast<std::uint32_t>(sum);
      carry = sum >> 32;
    }
    product[static_cast<std::size_t>(used_words + half)] = static_cast<std::uint32_t>(carry);
  }
  return product;
}

/// The 64 bits of the product from bit `low` upwards; zeros beyond its end. @pre low ≥ 0
std::uint64_t bits_from(const Product& product, int low) {
  const auto word = [&](int i) -> std::uint64_t {
    return i < static_cast<int>(product.size()) ? product[static_cast<std::size_t>(i)] : 0;
  };
  const int i = low / 32;
  const int shift = low % 32;
  const std::uint64_t lower = (word(i) | word(i + 1) << 32) >> shift;
  return shift == 0 ? lower : lower | word(i + 2) << (64 - shift);
}

/// The fraction 0.(upper)(lower) in binary, as two doubles.
DoubleDouble from_fraction(std::uint64_t upper, std::uint64_t lower) {
  if (upper == 0 && lower == 0) return {0.0, 0.0};
  int zeros = 0;
  if (upper == 0) {
    upper = lower;
    lower = 0;
    zeros = 64;
  }
  const int shift = std::countl_zero(upper);
  if (shift > 0) {
    upper = upper << shift | lower >> (64 - shift);
    lower <<= shift;
    zeros += shift;
  }
  const double high = static_cast<double>(upper >> 11) * power_of_two(-53 - zeros);
  const double low = static_cast<double>((upper & 0x7ffu) << 42 | lower >> 22) * power_of_two(-106 - zeros);
  return {high, low};
}

}  // namespace

ReducedAngle reduce_angle(double x) {
  constexpr double quarter_pi = 0.78539816339744828;
  const double size = magnitude(x);
  if (size <= quarter_pi) return {0, {x, 0.0}};

  // size = mantissa · 2^exponent; words whose product is a multiple of four quadrants are left out.
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(size);
  const std::uint64_t mantissa = (bits & 0x000fffffffffffffu) | 0x0010000000000000u;
  const int exponent = static_cast<int>(bits >> 52) - 1075;
  const int first = std::max(0, (exponent - 2) / 32);
  const Product product = multiply_words(mantissa, first);

  // The binary point stands above this many bits of the product.
  const int point = 32 * (first + used_words) - exponent;
  unsigned quadrant = static_cast<unsigned>(bits_from(product, point) & 3u);
  std::uint64_t upper = bits_from(product, point - 64);
  std::uint64_t lower = bits_from(product, point - 128);

  // Round to the nearest quadrant.
  const bool above_half = (upper & sign_bit) != 0;
  if (above_half) {
    ++quadrant;
    lower = ~lower + 1;
    upper = ~upper + (lower == 0 ? 1 : 0);
  }
  DoubleDouble remainder = multiply(half_pi, from_fraction(upper, lower));
  if (above_half != is_negative(x)) remainder = {-remainder.high, -remainder.low};
  if (is_negative(x)) quadrant = 4u - quadrant;
  return {quadrant & 3u, remainder};
}

}  // namespace velum::elementary
