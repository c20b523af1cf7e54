#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "../base/rect.hpp"
#include "colour.hpp"
#include "image.hpp"

namespace velum {

/// How the pixels of a larger picture are weighed into one of a smaller. x is the distance from the pixel's
/// centre along one axis, in pixels of the smaller picture; a picture is filtered along its rows, then along
/// its columns.
enum class DownsampleFilter {
  box,      ///< radius ½: the mean over the pixel's own square
  tent,     ///< radius 1: 1 - |x|
  mitchell  ///< radius 2: Mitchell & Netravali 1988, "Reconstruction filters in computer graphics", B = C =
            ///< 1/3: sharper; its lobes beyond 1 are negative
};

/// Where a filter becomes 0, in pixels of the smaller picture.
constexpr double radius_of(DownsampleFilter filter) {
  return filter == DownsampleFilter::box ? 0.5 : (filter == DownsampleFilter::tent ? 1.0 : 2.0);
}

/// The filter's value at a distance, before all weights of a pixel are scaled to sum 1.
double filter_value(DownsampleFilter filter, double x);

/// The pixels of a row (column) of the larger picture that make one of the smaller, and their weights.
struct FilterTaps {
  int first = 0;
  std::vector<float> weights;  ///< sum 1 up to float32

  int end() const { return first + static_cast<int>(weights.size()); }
};

/// @param scale  the larger picture's size over the smaller's, ≥ 1
/// @param pixel  of the smaller picture
/// @param size   the smaller picture's width (height): what would lie beyond its border is left out, and the
///               rest weighs more
FilterTaps taps_of(DownsampleFilter filter, int scale, int pixel, int size);

/// Makes a picture, or a part of one, from `scale` times as many rows and columns. Filters in linear light,
/// premultiplied, in float32 and one order, row by row of the larger picture, of which it keeps none; clamps
/// what a negative lobe overshoots (alpha to 0 … 1, colour to 0 … alpha) and encodes.
class Downsampler {
 public:
  /// @param width, height  of the whole smaller picture
  /// @param part    the pixels wanted of it. @pre inside, not empty
  /// @param target  of part's size
  Downsampler(DownsampleFilter filter, int scale, int width, int height, const Rect& part,
              const ImageView<Rgba8>& target);

  /// The pixels of the larger picture that are needed: part's, and as many around them as the filter takes.
  const Rect& source() const { return source_; }

  /// Takes the next row of the source, from the top. @param row  source().width pixels
  void add_row(const Rgba8* row);

 private:
  /// A row of the smaller picture that is being summed up.
  struct OpenRow {
    int y = 0;
    FilterTaps taps;
    std::vector<glm::vec4> sum;
  };

  void open_rows();
  void filter_row(const Rgba8* row);
  void write(const OpenRow& row) const;

  DownsampleFilter filter_;
  int scale_;
  int height_;
  Rect part_;
  ImageView<Rgba8> target_;
  Rect source_;
  std::vector<FilterTaps> columns_;
  std::vector<OpenRow> open_;
  int next_row_;   ///< of the source, the next to come
  int next_open_;  ///< of the smaller picture, the next to be opened
  std::vector<glm::vec4> decoded_, filtered_;
};

}  // namespace velum
