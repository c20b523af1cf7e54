#include "paint.hpp"

#include <algorithm>

namespace velum_docs {

using namespace velum;

Rgba8 with_alpha(Rgba8 colour, std::uint8_t alpha) {
  colour.a = alpha;
  return colour;
}

void paint_image(Canvas& canvas, const Image<Rgba8>& image, int left, int top, int scale) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      canvas.rectangle(left + x * scale, top + y * scale, scale, scale, image.at(x, y));
  }
}

Image<Rgba8> side_by_side(std::span<const Image<Rgba8>> pictures, int gap) {
  int width = -gap, height = 0;
  for (const Image<Rgba8>& picture : pictures) {
    width += picture.width() + gap;
    height = std::max(height, picture.height());
  }
  Image<Rgba8> result(width, height, paper);
  int left = 0;
  for (const Image<Rgba8>& picture : pictures) {
    for (int y = 0; y < picture.height(); ++y)
      std::copy_n(picture.row(y), picture.width(), result.row(y) + left);
    left += picture.width() + gap;
  }
  return result;
}

}  // namespace velum_docs
