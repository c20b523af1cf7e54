#include "z_pyramid.hpp"

#include <algorithm>

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

}  // namespace

/// Pixels left … right of rows top … bottom against a depth.
struct ZPyramid::Question {
  int left, top, right, bottom;
  float bound;
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

bool ZPyramid::quadrants_are_hidden(const Question& q, int level, int x, int y, PyramidAnswer& answer) const {
  const int below = level - 1;
  const int left = std::max(2 * x, q.left >> below), right = std::min(2 * x + 1, q.right >> below);
  const int top = std::max(2 * y, q.top >> below), bottom = std::min(2 * y + 1, q.bottom >> below);
  for (int row = top; row <= bottom; ++row) {
    for (int column = left; column <= right; ++column) {
      if (!is_hidden_below(q, below, column, row, answer)) return false;
    }
  }
  return true;
}

bool ZPyramid::is_hidden_below(const Question& q, int level, int x, int y, PyramidAnswer& answer) const {
  answer.level = std::min(answer.level, level);
  const float farthest = level == 0 ? base_.at(x, y) : above_[static_cast<std::size_t>(level) - 1].at(x, y);
  if (q.bound < farthest) return true;
  const int last = (1 << level) - 1;
  const bool is_inside = q.left <= x << level && (x << level) + last <= q.right && q.top <= y << level &&
                         (y << level) + last <= q.bottom;
  if (level == 0 || is_inside) return false;  // one of its pixels says no
  return quadrants_are_hidden(q, level, x, y, answer);
}

PyramidAnswer ZPyramid::is_hidden(const Rect& rect, float bound) const {
  const Rect seen = intersect(rect, {0, 0, base_.width, base_.height});
  if (seen.is_empty()) return {true, levels() - 1};
  const Question q{seen.left, seen.top, seen.right() - 1, seen.bottom() - 1, bound};
  PyramidAnswer answer{true, coarsest_};
  for (int y = q.top >> coarsest_; y <= q.bottom >> coarsest_; ++y) {
    for (int x = q.left >> coarsest_; x <= q.right >> coarsest_; ++x) {
      if (is_hidden_below(q, coarsest_, x, y, answer)) continue;
      answer.is_hidden = false;
      return answer;
    }
  }
  return answer;
}

}  // namespace velum
