#pragma once

#include <algorithm>

namespace velum {

/// A rectangle of pixels: left ≤ x < right(), top ≤ y < bottom(); y points down.
struct Rect {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;

  int right() const { return left + width; }
  int bottom() const { return top + height; }
  bool is_empty() const { return width <= 0 || height <= 0; }
  bool contains(int x, int y) const { return left <= x && x < right() && top <= y && y < bottom(); }
  bool operator==(const Rect&) const = default;
};

/// The common part of two rectangles; empty (zero size) when they do not meet.
inline Rect intersect(const Rect& a, const Rect& b) {
  const int left = std::max(a.left, b.left);
  const int top = std::max(a.top, b.top);
  return {left, top, std::max(0, std::min(a.right(), b.right()) - left),
          std::max(0, std::min(a.bottom(), b.bottom()) - top)};
}

/// The smallest rectangle around both; an empty one adds nothing.
inline Rect united(const Rect& a, const Rect& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  const int left = std::min(a.left, b.left);
  const int top = std::min(a.top, b.top);
  return {left, top, std::max(a.right(), b.right()) - left, std::max(a.bottom(), b.bottom()) - top};
}

}  // namespace velum
