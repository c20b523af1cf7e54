#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <limits>
#include <string>

#include "../base/error.hpp"
#include "colour.hpp"
#include "image.hpp"

// How far two pixels are apart; private to compare.cpp and heat_map.cpp.

namespace velum {

/// Absolute; two NaNs, or two equal infinities, differ by 0, and by infinity from anything else.
inline double difference(double a, double b) {
  const bool a_is_nan = a != a;
  const bool b_is_nan = b != b;
  if (a == b || (a_is_nan && b_is_nan)) return 0.0;
  const double signed_difference = a - b;
  if (signed_difference != signed_difference) return std::numeric_limits<double>::infinity();
  return signed_difference < 0.0 ? -signed_difference : signed_difference;
}

inline std::array<double, 4> channel_differences(const Rgba8& a, const Rgba8& b) {
  return {difference(a.r, b.r), difference(a.g, b.g), difference(a.b, b.b), difference(a.a, b.a)};
}
inline std::array<double, 1> channel_differences(float a, float b) {
  return {difference(a, b)};
}
inline std::array<double, 3> channel_differences(const glm::vec3& a, const glm::vec3& b) {
  return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

/// @throws Error (usage) when the sizes differ
template <typename Pixel>
void demand_same_size(ImageView<const Pixel> a, ImageView<const Pixel> b) {
  if (a.width == b.width && a.height == b.height) return;
  const auto size = [](int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
  };
  throw Error(ErrorKind::usage,
              "the pictures differ in size: " + size(a.width, a.height) + " and " + size(b.width, b.height),
              "", "compare pictures of one size");
}

}  // namespace velum
