#include "compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "../base/elementary.hpp"
#include "../base/error.hpp"

namespace velum {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double difference(double a, double b) {
  const bool a_is_nan = a != a;
  const bool b_is_nan = b != b;
  if (a == b || (a_is_nan && b_is_nan)) return 0.0;
  const double signed_difference = a - b;
  if (signed_difference != signed_difference) return infinity;
  return signed_difference < 0.0 ? -signed_difference : signed_difference;
}

std::array<double, 4> channel_differences(const Rgba8& a, const Rgba8& b) {
  return {difference(a.r, b.r), difference(a.g, b.g), difference(a.b, b.b), difference(a.a, b.a)};
}
std::array<double, 1> channel_differences(float a, float b) {
  return {difference(a, b)};
}
std::array<double, 3> channel_differences(const glm::vec3& a, const glm::vec3& b) {
  return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

double decibels(double peak, double rmse) {
  if (rmse == 0.0) return infinity;
  constexpr double ln_10 = 2.30258509299404568402;
  return 20.0 * elementary::log(peak / rmse) / ln_10;
}

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

template <typename Pixel>
ImageDifference compare_pixels(ImageView<const Pixel> a, ImageView<const Pixel> b, double threshold,
                               double peak) {
  demand_same_size(a, b);
  ImageDifference result;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  double channels = 0.0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      double largest = 0.0;
      for (const double each : channel_differences(a.at(x, y), b.at(x, y))) {
        sum += each;
        sum_of_squares += each * each;
        channels += 1.0;
        largest = std::max(largest, each);
      }
      result.same_bytes = result.same_bytes && std::memcmp(&a.at(x, y), &b.at(x, y), sizeof(Pixel)) == 0;
      if (largest > threshold) ++result.pixels_over;
      if (largest > result.max) {
        result.max = largest;
        result.worst_x = x;
        result.worst_y = y;
      }
    }
  }
  if (channels > 0.0) {
    result.mean = sum / channels;
    result.rmse = std::sqrt(sum_of_squares / channels);
  }
  result.psnr = decibels(peak, result.rmse);
  return result;
}

}  // namespace

ImageDifference compare(ImageView<const Rgba8> a, ImageView<const Rgba8> b, double threshold) {
  return compare_pixels(a, b, threshold, 255.0);
}
ImageDifference compare(ImageView<const float> a, ImageView<const float> b, double threshold, double peak) {
  return compare_pixels(a, b, threshold, peak);
}
ImageDifference compare(ImageView<const glm::vec3> a, ImageView<const glm::vec3> b, double threshold,
                        double peak) {
  return compare_pixels(a, b, threshold, peak);
}

}  // namespace velum
