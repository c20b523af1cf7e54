#include "spans.hpp"

#include <algorithm>

namespace velum_docs {

using namespace velum;

SpanTable::SpanTable(const Subject& subject, ZInterpolation interpolation)
    : buffer_(subject.settings.width, subject.settings.height) {
  const Rect whole{0, 0, buffer_.width(), buffer_.height()};
  rasterize_scanline(subject.triangle.pieces, {buffer_, whole}, interpolation);
  int left = buffer_.width(), right = 0;
  for (int y = 0; y < buffer_.height(); ++y) {
    Span span{y, -1, -1};
    for (int x = 0; x < buffer_.width(); ++x) {
      if (!covers(x, y)) continue;
      if (span.first < 0) span.first = x;
      span.last = x;
    }
    if (span.first < 0) continue;
    left = std::min(left, span.first);
    right = std::max(right, span.last + 1);
    spans_.push_back(span);
  }
  if (!spans_.empty())
    box_ = {left, spans_.front().row, right - left, spans_.back().row + 1 - spans_.front().row};
}

}  // namespace velum_docs
