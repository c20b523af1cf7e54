#include "compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "../base/elementary.hpp"
#include "pixel_difference.hpp"

namespace velum {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double decibels(double peak, double rmse) {
  if (rmse == 0.0) return infinity;
  constexpr double ln_10 = 2.30258509299404568402;
  return 20.0 * elementary::log(peak / rmse) / ln_10;
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
