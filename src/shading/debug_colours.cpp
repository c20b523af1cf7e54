#include "debug_colours.hpp"

#include <array>
#include <cstdint>

#include "../image/colour.hpp"
#include "../image/visibility_buffer.hpp"
#include "shading.hpp"

namespace velum {
namespace {

std::uint8_t code(float value) {
  if (!(value > 0.0f)) return 0;
  return value >= 1.0f ? 255 : static_cast<std::uint8_t>(value * 255.0f + 0.5f);
}

/// Hue, saturation and value as 16-bit fractions → sRGB codes, in whole numbers (Smith 1978, "Color Gamut
/// Transform Pairs").
Rgba8 rgb_from_hsv(std::uint32_t hue, std::uint32_t saturation, std::uint32_t value) {
  const std::uint32_t sector = hue * 6 >> 16;
  const std::uint32_t fraction = hue * 6 & 0xFFFFu;
  const auto channel = [&](std::uint32_t part) {
    const std::uint32_t kept = 0xFFFFu - (saturation * part >> 16);
    return static_cast<std::uint8_t>(((value * kept >> 16) * 255u + 0x8000u) >> 16);
  };
  const std::uint8_t high = channel(0), low = channel(0xFFFFu);
  const std::uint8_t falling = channel(fraction), rising = channel(0xFFFFu - fraction);
  const std::array<Rgba8, 6> sectors{{{high, rising, low, 255},
                                      {falling, high, low, 255},
                                      {low, high, rising, 255},
                                      {low, falling, high, 255},
                                      {rising, low, high, 255},
                                      {high, low, falling, 255}}};
  return sectors[sector];
}

}  // namespace

glm::vec4 colour_of_codes(const glm::vec3& values) {
  return linear_from_srgb(codes_of(values));
}

Rgba8 codes_of(const glm::vec3& values) {
  return {code(values.x), code(values.y), code(values.z), 255};
}

glm::vec4 normal_colour(const glm::vec3& unit_normal) {
  return colour_of_codes(normal_values(unit_normal));
}

glm::vec3 depth_values(double metric_depth, const MetricRange& range) {
  constexpr double darkest = 0.1;
  const double extent = range.farthest - range.nearest;
  const double share = extent > 0.0 ? (metric_depth - range.nearest) / extent : 0.0;
  return glm::vec3(static_cast<float>(1.0 - (1.0 - darkest) * share));
}

glm::vec4 depth_colour(double metric_depth, const MetricRange& range) {
  return colour_of_codes(depth_values(metric_depth, range));
}

// Multiples of irrational numbers modulo 1 spread evenly (Weyl 1916) and put neighbours far apart: hue by the
// golden ratio (0.618), saturation by the inverse plastic number (0.755), value by √2 (0.414), in 32-bit
// fixed point. Of the usual constants these keep the first hundreds of ids farthest apart.
glm::vec4 id_colour(std::uint32_t id) {
  if (id == no_primitive) return {0.0f, 0.0f, 0.0f, 1.0f};
  const std::uint32_t hue = (id * 0x9E3779B9u) >> 16;
  const std::uint32_t saturation = 0xFFFFu - (((id * 0xC13FA9A9u) >> 16) * 0x9000u >> 16);
  const std::uint32_t value = 0xFFFFu - (((id * 0x6A09E667u) >> 16) * 0x8000u >> 16);
  return linear_from_srgb(rgb_from_hsv(hue, saturation, value));
}

}  // namespace velum
