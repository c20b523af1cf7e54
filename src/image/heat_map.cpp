#include "heat_map.hpp"

#include <algorithm>
#include <cmath>

#include "pixel_difference.hpp"

namespace velum {
namespace {

template <typename Pixel>
double largest_difference(const Pixel& a, const Pixel& b) {
  const auto channels = channel_differences(a, b);
  return *std::max_element(channels.begin(), channels.end());
}

// The colours of a glowing body: first red rises, then green, then blue.
Rgba8 glow(double share) {
  const auto code = [](double level) {
    return static_cast<std::uint8_t>(255.0 * std::clamp(level, 0.0, 1.0) + 0.5);
  };
  return {code(3.0 * share), code(3.0 * share - 1.0), code(3.0 * share - 2.0), 255};
}

// Small differences must be seen beside equal pixels: the scale begins well above black and rises as a root.
Rgba8 heat(double difference, double white) {
  const double share = difference < white ? difference / white : 1.0;
  return glow(0.2 + 0.8 * std::sqrt(share));
}

Rgba8 dimmed(const Rgba8& pixel) {
  const auto grey = static_cast<std::uint8_t>((pixel.r + 2 * pixel.g + pixel.b) * pixel.a / (4 * 255) / 3);
  return {grey, grey, grey, 255};
}

template <typename Pixel>
double largest_finite_difference(ImageView<const Pixel> a, ImageView<const Pixel> b) {
  double largest = 0.0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      for (const double each : channel_differences(a.at(x, y), b.at(x, y))) {
        if (each < std::numeric_limits<double>::infinity()) largest = std::max(largest, each);
      }
    }
  }
  return largest;
}

template <typename Pixel, typename Background>
Image<Rgba8> map_differences(ImageView<const Pixel> a, ImageView<const Pixel> b, double white,
                             Background background) {
  Image<Rgba8> result(a.width, a.height);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const double difference = largest_difference(a.at(x, y), b.at(x, y));
      result.at(x, y) = difference > 0.0 ? heat(difference, white) : background(a.at(x, y));
    }
  }
  return result;
}

template <typename Pixel>
Image<Rgba8> map_floats(ImageView<const Pixel> a, ImageView<const Pixel> b) {
  demand_same_size(a, b);
  const double white = largest_finite_difference(a, b);
  return map_differences(a, b, white, [](const Pixel&) { return Rgba8{}; });
}

}  // namespace

Image<Rgba8> heat_map(ImageView<const Rgba8> a, ImageView<const Rgba8> b) {
  demand_same_size(a, b);
  return map_differences(a, b, 255.0, dimmed);
}
Image<Rgba8> heat_map(ImageView<const float> a, ImageView<const float> b) {
  return map_floats(a, b);
}
Image<Rgba8> heat_map(ImageView<const glm::vec3> a, ImageView<const glm::vec3> b) {
  return map_floats(a, b);
}

}  // namespace velum
