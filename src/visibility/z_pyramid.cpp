#include "z_pyramid.hpp"

#include <algorithm>
#include <type_traits>

namespace velum {
namespace {

/// The farthest of two, and two, neighbours for every cell from `first` to before `end`.
/// @param upper, lower  rows of the level below, child_width long; the same row where there is only one
void reduce(const float* upper, const float* lower, int child_width, int first, int end, float* out) {
  const int whole = std::min(end, child_width / 2);
  for (int x = first; x < whole; ++x) {
    out[x] = std::min(std::min(upper[2 * x], upper[2 * x + 1]), std::min(lower[2 * x], lower[2 * x + 1]));
  }
  if (whole < end) out[whole] = std::min(upper[2 * whole], lower[2 * whole]);  // a last, odd column
}

/// One depth for all pixels.
struct ConstantBound {
  float depth;
  float operator()(const Rect&) const { return depth; }
};

/// A plane's nearest depth in a rectangle: it is monotone in x and in y.
struct PlaneBound {
  const DepthPlane& plane;
  int left, top;
  float operator()(const Rect& r) const {
    return plane.at(left + (plane.dx > 0.0f ? r.right() - 1 : r.left),
                    top + (plane.dy > 0.0f ? r.bottom() - 1 : r.top));
  }
};

}  // namespace

/// The way of one question down the levels.
template <typename Bound>
class ZPyramid::Descent {
 public:
  Descent(const ZPyramid& pyramid, const Rect& rect, const Bound& bound)
      : pyramid_(pyramid), rect_(rect), bound_(bound), answer_{true, pyramid.coarsest_} {}

  PyramidAnswer go() {
    int level = pyramid_.coarsest_;
    const int right = rect_.right() - 1, bottom = rect_.bottom() - 1;
    // As long as one cell holds it, without the general case's comparisons.
    const auto is_in_one_cell = [&] {
      return rect_.left >> level == right >> level && rect_.top >> level == bottom >> level;
    };
    const float nearest = bound_(rect_);
    for (; level > 0 && is_in_one_cell(); --level) {
      if (nearest < pyramid_.value(level, rect_.left >> level, rect_.top >> level)) return {true, level};
    }
    answer_.level = level;
    answer_.is_hidden = cells_are_hidden(level, rect_.left >> level, rect_.top >> level,
                                         (rect_.right() - 1) >> level, (rect_.bottom() - 1) >> level);
    return answer_;
  }

 private:
  bool cells_are_hidden(int level, int left, int top, int right, int bottom) {
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        if (!cell_is_hidden(level, x, y)) return false;
      }
    }
    return true;
  }

  bool cell_is_hidden(int level, int x, int y) {
    answer_.level = std::min(answer_.level, level);
    const int side = 1 << level;
    const Rect cell{x << level, y << level, side, side};
    const Rect part = intersect(cell, rect_);
    if (bound_(part) < pyramid_.value(level, x, y)) return true;
    // One of the pixels of a cell wholly inside is as far as the cell; but a plane's bound there may be less.
    if (level == 0 || (std::is_same_v<Bound, ConstantBound> && part == cell)) return false;
    const int below = level - 1;
    return cells_are_hidden(below, part.left >> below, part.top >> below, (part.right() - 1) >> below,
                            (part.bottom() - 1) >> below);
  }

  const ZPyramid& pyramid_;
  const Rect& rect_;
  const Bound& bound_;
  PyramidAnswer answer_;
};

void ZPyramid::begin(const ImageView<const float>& z_buffer) {
  VELUM_REQUIRE(z_buffer.width >= 1 && z_buffer.height >= 1, {"width", z_buffer.width},
                {"height", z_buffer.height});
  base_ = z_buffer;
  std::size_t count = 0;
  for (int w = z_buffer.width, h = z_buffer.height; w > 1 || h > 1; ++count) {
    w = (w + 1) / 2;
    h = (h + 1) / 2;
    if (count == above_.size()) above_.emplace_back();
    above_[count].resize(w, h, 0.0f);
  }
  above_.resize(count);
  coarsest_ = 0;
}

void ZPyramid::build(const ImageView<const float>& z_buffer) {
  begin(z_buffer);
  update({0, 0, z_buffer.width, z_buffer.height});
}

void ZPyramid::update(const Rect& rect, int first, int last) {
  if (rect.is_empty()) return;
  for (int i = first; i <= last; ++i) {
    const ImageView<const float> below = level(i - 1);
    Image<float>& image = above_[static_cast<std::size_t>(i) - 1];
    const int left = rect.left >> i, end = ((rect.right() - 1) >> i) + 1;
    for (int y = rect.top >> i; y <= (rect.bottom() - 1) >> i; ++y) {
      const float* const upper = below.row(2 * y);
      const float* const lower = 2 * y + 1 < below.height ? below.row(2 * y + 1) : upper;
      reduce(upper, lower, below.width, left, end, image.row(y));
    }
  }
  if (last == levels() - 1) find_coarsest();
}

void ZPyramid::find_coarsest() {
  constexpr int enough = 4096;  // cells; finer levels than that are not worth looking for
  for (coarsest_ = levels() - 1; coarsest_ > 0; --coarsest_) {
    const ImageView<const float> view = level(coarsest_);
    if (view.width * view.height > enough) return;
    for (int y = 0; y < view.height; ++y) {
      const float* const row = view.row(y);
      if (std::any_of(row, row + view.width, [](float r) { return r > 0.0f; })) return;
    }
  }
}

template <typename Bound>
PyramidAnswer ZPyramid::descend(const Rect& rect, const Bound& bound) const {
  const Rect seen = intersect(rect, {0, 0, base_.width, base_.height});
  if (seen.is_empty()) return {true, levels() - 1};
  return Descent<Bound>(*this, seen, bound).go();
}

PyramidAnswer ZPyramid::is_hidden(const Rect& rect, float bound) const {
  return descend(rect, ConstantBound{bound});
}

PyramidAnswer ZPyramid::is_hidden(const Rect& rect, const DepthPlane& plane, int left, int top) const {
  return descend(rect, PlaneBound{plane, left, top});
}

}  // namespace velum
