#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace velum {

/// An 8-bit sRGB colour with straight (not premultiplied) alpha, as it stands in files.
struct Rgba8 {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;

  bool operator==(const Rgba8&) const = default;
};

/// sRGB code 0…255 → linear 0…1 (IEC 61966-2-1), from a table.
float linear_from_srgb(std::uint8_t code);
/// Linear → the sRGB code whose linear interval holds it; decided by table, half up. Below 0 and NaN give 0,
/// above 1 gives 255.
std::uint8_t srgb_from_linear(float linear);

/// Colour channels decoded; alpha scaled to 0…1. Straight alpha.
glm::vec4 linear_from_srgb(const Rgba8& colour);
/// @param linear  straight alpha, linear channels
Rgba8 srgb_from_linear(const glm::vec4& linear);
/// The same of many. @param channels  red, green, blue, alpha: `count` values each
void srgb_from_linear(const float* const (&channels)[4], std::size_t count, Rgba8* out);

}  // namespace velum
