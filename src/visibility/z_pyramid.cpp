#include "z_pyramid.hpp"

#include <algorithm>
#include <bit>
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

/// The cells of one level that hold a rectangle, ends included.
struct Cells {
  int left, top, right, bottom;

  bool is_empty() const { return left > right || top > bottom; }
  int count() const { return (right - left + 1) * (bottom - top + 1); }
};
Cells cells_around(const Rect& rect, int level) {
  return {rect.left >> level, rect.top >> level, (rect.right() - 1) >> level, (rect.bottom() - 1) >> level};
}
/// Those that lie wholly inside it.
Cells cells_within(const Rect& rect, int level) {
  const int most = (1 << level) - 1;
  return {(rect.left + most) >> level, (rect.top + most) >> level, (rect.right() >> level) - 1,
          (rect.bottom() >> level) - 1};
}

bool are_all_nearer(const ImageView<const float>& level, const Cells& cells, float bound) {
  for (int y = cells.top; y <= cells.bottom; ++y) {
    const float* const row = level.row(y);
    float farthest = row[cells.left];
    for (int x = cells.left + 1; x <= cells.right; ++x) farthest = std::min(farthest, row[x]);
    if (!(bound < farthest)) return false;
  }
  return true;
}

}  // namespace

/// The way of one question down the levels.
template <typename Bound>
class ZPyramid::Descent {
 public:
  Descent(const ZPyramid& pyramid, const Rect& rect, const Bound& bound)
      : pyramid_(pyramid), rect_(rect), bound_(bound), answer_{true, pyramid.coarsest_} {}

  PyramidAnswer go(int level) {
    answer_.level = level;
    const Cells cells = cells_around(rect_, level);
    answer_.is_hidden = cells_are_hidden(level, cells.left, cells.top, cells.right, cells.bottom);
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
PyramidAnswer ZPyramid::below(const Rect& rect, const Bound& bound, int first) const {
  return Descent<Bound>(*this, rect, bound).go(first);
}

/// Few cells are sooner looked at all than one by one where it is undecided.
template <>
PyramidAnswer ZPyramid::below(const Rect& rect, const ConstantBound& bound, int first) const {
  constexpr int many = 64;
  for (int i = first; i >= 0; --i) {
    const Cells cells = cells_around(rect, i);
    if (cells.count() > many) return Descent<ConstantBound>(*this, rect, bound).go(i);
    if (are_all_nearer(level(i), cells, bound.depth)) return {true, i};
    const Cells within = cells_within(rect, i);
    if (!within.is_empty() && !are_all_nearer(level(i), within, bound.depth)) return {false, i};
  }
  return {false, 0};
}

template <typename Bound>
PyramidAnswer ZPyramid::descend(const Rect& rect, const Bound& bound) const {
  const Rect seen = intersect(rect, {0, 0, base_.width, base_.height});
  if (seen.is_empty()) return {true, levels() - 1};
  // The finest level with a cell that holds all of it: where that cell is too far, those above are, too.
  const int differing = (seen.left ^ (seen.right() - 1)) | (seen.top ^ (seen.bottom() - 1));
  const int one_cell = static_cast<int>(std::bit_width(static_cast<unsigned>(differing)));
  const auto is_hidden_at = [&, nearest = bound(seen)](int i) {
    return nearest < value(i, seen.left >> i, seen.top >> i);
  };
  if (one_cell <= coarsest_ && is_hidden_at(one_cell)) {
    int level = coarsest_;
    while (!is_hidden_at(level)) --level;
    return {true, level};
  }
  if (one_cell == 0) return {false, 0};
  return below(seen, bound, std::min(one_cell - 1, coarsest_));
}

PyramidAnswer ZPyramid::is_hidden(const Rect& rect, float bound) const {
  return descend(rect, ConstantBound{bound});
}

PyramidAnswer ZPyramid::is_hidden(const Rect& rect, const DepthPlane& plane, int left, int top) const {
  return descend(rect, PlaneBound{plane, left, top});
}

}  // namespace velum
