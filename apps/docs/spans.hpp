#pragma once

#include <vector>
#include <velum/velum.hpp>
#include <velum/visibility/scanline.hpp>

#include "subject.hpp"

namespace velum_docs {

/// A run of covered pixel centres in a row, both ends covered.
struct Span {
  int row = 0;
  int first = 0;
  int last = 0;
};

/// The triangle alone on the picture, by the scanline method: its spans and its depth at every pixel.
class SpanTable {
 public:
  explicit SpanTable(const Subject& subject,
                     velum::ZInterpolation interpolation = velum::ZInterpolation::plane);

  const std::vector<Span>& spans() const { return spans_; }
  /// The smallest rectangle around all spans.
  const velum::Rect& box() const { return box_; }
  /// @pre (x, y) is covered
  float reversed_depth(int x, int y) const { return buffer_.reversed_depth.at(x, y); }
  bool covers(int x, int y) const { return buffer_.primitive.at(x, y) != velum::no_primitive; }

 private:
  velum::VisibilityBuffer buffer_;
  std::vector<Span> spans_;
  velum::Rect box_;
};

}  // namespace velum_docs
