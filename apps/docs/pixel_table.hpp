#pragma once

#include <functional>
#include <string>

#include "spans.hpp"
#include "table.hpp"

namespace velum_docs {

/// A block of plain text: rows and columns of pixels, with the text for each pixel that the triangle covers.
inline std::string pixel_table(const SpanTable& spans,
                               const std::function<std::string(int x, int y)>& text_of) {
  const velum::Rect& box = spans.box();
  std::vector<std::string> header{"y \\ x"};
  for (int x = box.left; x < box.right(); ++x) header.push_back(std::to_string(x));
  Table table(header);
  for (const Span& span : spans.spans()) {
    std::vector<std::string> row{std::to_string(span.row)};
    for (int x = box.left; x < box.right(); ++x)
      row.push_back(spans.covers(x, span.row) ? text_of(x, span.row) : "");
    table.add(row);
  }
  return table.text();
}

}  // namespace velum_docs
