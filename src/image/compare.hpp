#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "colour.hpp"
#include "image.hpp"

namespace velum {

/// How far two pictures of one size are apart. Differences are absolute, per channel; for Rgba8 in sRGB codes
/// 0…255 with alpha as a fourth channel, for floats in the picture's own unit. Two NaNs, or two equal
/// infinities, differ by 0; a NaN or an infinity differs from anything else by infinity.
struct ImageDifference {
  bool same_bytes = true;  ///< every pixel has the same bits: tells 0 from -0, and one NaN from another
  double max = 0.0;        ///< largest difference
  double mean = 0.0;       ///< over all channels of all pixels
  double rmse = 0.0;       ///< root of the mean square, over the same
  double psnr = 0.0;       ///< 20·log10(peak / rmse) in decibels; infinity where rmse is 0
  std::uint64_t pixels_over = 0;  ///< pixels with a channel that differs by more than the threshold
  int worst_x = 0;                ///< the first pixel, row by row, with the largest difference
  int worst_y = 0;
};

/// @param threshold for pixels_over, in the same unit
/// @param peak      for psnr: the largest value a channel can have
/// @throws Error (usage) when the sizes differ
ImageDifference compare(ImageView<const Rgba8> a, ImageView<const Rgba8> b, double threshold = 0.0);
ImageDifference compare(ImageView<const float> a, ImageView<const float> b, double threshold = 0.0,
                        double peak = 1.0);
ImageDifference compare(ImageView<const glm::vec3> a, ImageView<const glm::vec3> b, double threshold = 0.0,
                        double peak = 1.0);

}  // namespace velum
