#include "pyramid_drawing.hpp"

#include <algorithm>
#include <string>

#include "canvas.hpp"

namespace velum {
namespace {

constexpr Rgba8 background{38, 70, 140, 255};
constexpr Rgba8 ink{20, 20, 20, 255};

/// The smallest and the largest depth that is not background.
struct DepthSpan {
  float farthest = 1.0f;
  float nearest = 0.0f;
};

DepthSpan span_of(const ImageView<const float>& level) {
  DepthSpan span;
  for (int y = 0; y < level.height; ++y) {
    for (int x = 0; x < level.width; ++x) {
      const float r = level.at(x, y);
      if (!(r > 0.0f)) continue;
      span.farthest = std::min(span.farthest, r);
      span.nearest = std::max(span.nearest, r);
    }
  }
  return span;
}

Rgba8 colour_of(float r, const DepthSpan& span) {
  if (!(r > 0.0f)) return background;
  const float range = span.nearest - span.farthest;
  const float share = range > 0.0f ? (r - span.farthest) / range : 1.0f;
  const auto grey = static_cast<std::uint8_t>(50.0f + 200.0f * share);
  return {grey, grey, grey, 255};
}

/// The level, each value as often as its cell is wide and high in a picture of this size.
Image<Rgba8> draw_level(const ImageView<const float>& level, int index, const ImageView<const float>& base,
                        const DepthSpan& span) {
  Image<Rgba8> picture(base.width, base.height);
  for (int y = 0; y < base.height; ++y) {
    for (int x = 0; x < base.width; ++x) {
      picture.at(x, y) = colour_of(level.at(x >> index, y >> index), span);
    }
  }
  return picture;
}

std::string title_of(const ZPyramid& pyramid, int index) {
  const ImageView<const float> level = pyramid.level(index);
  return "level " + std::to_string(index) + ": " + std::to_string(level.width) + "x" +
         std::to_string(level.height) + ", " +
         std::to_string(static_cast<int>(100.0 * share_that_hides(pyramid, index))) + " % can hide";
}

void paste(const Image<Rgba8>& picture, int left, int top, int step, Canvas& canvas) {
  for (int y = 0; y + step <= picture.height(); y += step) {
    for (int x = 0; x + step <= picture.width(); x += step) {
      canvas.rectangle(left + x / step, top + y / step, 1, 1, picture.at(x, y));
    }
  }
}

}  // namespace

std::vector<Image<Rgba8>> draw_pyramid_levels(const ZPyramid& pyramid) {
  std::vector<Image<Rgba8>> pictures;
  if (pyramid.levels() == 0) return pictures;
  const DepthSpan span = span_of(pyramid.level(0));
  for (int i = 0; i < pyramid.levels(); ++i) {
    pictures.push_back(draw_level(pyramid.level(i), i, pyramid.level(0), span));
  }
  return pictures;
}

// Cells at the right and at the bottom stand for fewer pixels.
double share_that_hides(const ZPyramid& pyramid, int index) {
  const ImageView<const float> base = pyramid.level(0), level = pyramid.level(index);
  const auto extent = [index](int cell, int size) {
    return std::min((cell + 1) << index, size) - (cell << index);
  };
  long long useful = 0;
  for (int y = 0; y < level.height; ++y) {
    const long long rows = extent(y, base.height);
    for (int x = 0; x < level.width; ++x) useful += level.at(x, y) > 0.0f ? rows * extent(x, base.width) : 0;
  }
  return static_cast<double>(useful) / (static_cast<double>(base.width) * base.height);
}

Image<Rgba8> draw_pyramid_sheet(const ZPyramid& pyramid, int columns) {
  constexpr int gap = 12, title_height = 14, wanted_width = 320;
  const std::vector<Image<Rgba8>> levels = draw_pyramid_levels(pyramid);
  if (levels.empty()) return {};
  const int step = std::max(1, levels[0].width() / wanted_width);
  const int width = std::max(levels[0].width() / step, 200), height = levels[0].height() / step;
  const int rows = (static_cast<int>(levels.size()) + columns - 1) / columns;
  Canvas canvas(gap + columns * (width + gap), gap + rows * (height + title_height + gap),
                {255, 255, 255, 255});
  for (int i = 0; i < static_cast<int>(levels.size()); ++i) {
    const int left = gap + i % columns * (width + gap);
    const int top = gap + i / columns * (height + title_height + gap);
    canvas.text({left, top}, title_of(pyramid, i), 1, ink);
    paste(levels[static_cast<std::size_t>(i)], left, top + title_height, step, canvas);
  }
  return canvas.picture();
}

}  // namespace velum
