#include "colour.hpp"

#include <array>
#include <cstddef>

#include "../base/elementary.hpp"
#include "../base/floating_point.hpp"

namespace velum {
namespace {

/// The decoding curve of IEC 61966-2-1:1999 for an encoded value 0…1.
double decode(double encoded) {
  if (encoded <= 0.04045) return encoded / 12.92;
  return elementary::pow((encoded + 0.055) / 1.055, 2.4);
}

/// The curve is steepest at 0, 12.92·255 = 3295 codes per unit: a cell never holds more than two code
/// boundaries.
constexpr int cells = 4096;

struct Tables {
  std::array<float, 256> linear;        ///< of each code
  std::array<double, 256> upper_bound;  ///< of each code's linear interval: where code + ½ lies; 255 has none
  std::array<std::uint8_t, cells> first_code;  ///< the code of each cell's lower end
};

Tables make_tables() {
  const FloatingPointScope scope;  // the first caller's rounding mode must not decide for all
  Tables tables{};
  for (std::size_t code = 0; code < 256; ++code) {
    tables.linear[code] = static_cast<float>(decode(static_cast<double>(code) / 255.0));
    tables.upper_bound[code] = decode((static_cast<double>(code) + 0.5) / 255.0);
  }
  std::size_t code = 0;
  for (std::size_t cell = 0; cell < cells; ++cell) {
    while (static_cast<double>(cell) / cells >= tables.upper_bound[code]) ++code;
    tables.first_code[cell] = static_cast<std::uint8_t>(code);
  }
  return tables;
}

const Tables& tables() {
  static const Tables made_once = make_tables();
  return made_once;
}

std::uint8_t encode(const Tables& table, float linear) {
  if (!(linear > 0.0f)) return 0;
  if (linear >= 1.0f) return 255;
  const double value = static_cast<double>(linear);
  std::size_t code = table.first_code[static_cast<std::size_t>(value * cells)];
  while (value >= table.upper_bound[code]) ++code;
  return static_cast<std::uint8_t>(code);
}

/// 0…1 → 0…255, half up.
std::uint8_t byte_from_unit(float value) {
  if (!(value > 0.0f)) return 0;
  if (value >= 1.0f) return 255;
  return static_cast<std::uint8_t>(static_cast<double>(value) * 255.0 + 0.5);
}

}  // namespace

float linear_from_srgb(std::uint8_t code) {
  return tables().linear[code];
}

std::uint8_t srgb_from_linear(float linear) {
  return encode(tables(), linear);
}

glm::vec4 linear_from_srgb(const Rgba8& colour) {
  return {linear_from_srgb(colour.r), linear_from_srgb(colour.g), linear_from_srgb(colour.b),
          static_cast<float>(colour.a) / 255.0f};
}

Rgba8 srgb_from_linear(const glm::vec4& linear) {
  return {srgb_from_linear(linear.r), srgb_from_linear(linear.g), srgb_from_linear(linear.b),
          byte_from_unit(linear.a)};
}

void srgb_from_linear(const float* const (&channels)[4], std::size_t count, Rgba8* out) {
  const Tables& table = tables();
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = {encode(table, channels[0][i]), encode(table, channels[1][i]), encode(table, channels[2][i]),
              byte_from_unit(channels[3][i])};
  }
}

}  // namespace velum
