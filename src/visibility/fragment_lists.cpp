#include "fragment_lists.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace velum {

void FragmentLists::begin_counting(const VisibilityBuffer& front, const Rect& rect, const Rect& wanted) {
  front_ = &front;
  rect_ = rect;
  wanted_ = wanted;
  is_counting_ = true;
  counts_.resize(wanted.width, wanted.height, 0);
}

namespace {

/// Cuts a row that is too large for one part.
void append_pieces(const std::uint32_t* counts, const Rect& row, std::uint64_t most,
                   std::vector<Rect>& parts) {
  std::uint64_t gathered = 0;
  for (int i = 0; i < row.width; ++i) {
    if (i == 0 || gathered + counts[i] > most) {
      gathered = 0;
      parts.push_back({row.left + i, row.top, 0, 1});
    }
    gathered += counts[i];
    ++parts.back().width;
  }
}

}  // namespace

const std::vector<Rect>& FragmentLists::parts(std::uint64_t most) {
  parts_.clear();
  bool may_grow = false;  // the last part by a whole row
  std::uint64_t gathered = 0;
  for (int i = 0; i < wanted_.height; ++i) {
    const Rect row{wanted_.left, wanted_.top + i, wanted_.width, 1};
    const std::uint32_t* const counts = counts_.row(i);
    const std::uint64_t of_row = count_of_row(row.top);
    if (may_grow && gathered + of_row <= most) {
      gathered += of_row;
      ++parts_.back().height;
      continue;
    }
    may_grow = of_row <= most;
    gathered = of_row;
    if (may_grow) {
      parts_.push_back(row);
    } else {
      append_pieces(counts, row, most, parts_);
    }
  }
  return parts_;
}

std::uint64_t FragmentLists::count_of_row(int y) const {
  const std::uint32_t* const counts = counts_.row(y - wanted_.top);
  return std::accumulate(counts, counts + wanted_.width, std::uint64_t{0});
}

void FragmentLists::begin_storing(const Rect& part) {
  part_ = part;
  is_counting_ = false;
  ends_.clear();
  std::uint32_t end = 0;
  for (int y = part.top; y < part.bottom(); ++y) {
    for (int x = part.left; x < part.right(); ++x) {
      ends_.push_back(end);
      end += counts_.at(x - wanted_.left, y - wanted_.top);
    }
  }
  fragments_.assign(end, 0);
}

void FragmentLists::sort() {
  std::size_t begin = 0;
  for (const std::uint32_t end : ends_) {
    const auto from = fragments_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = fragments_.begin() + static_cast<std::ptrdiff_t>(end);
    std::sort(from, to, std::greater<>());
    // A triangle that was cut may cover a pixel with two pieces, where snapping turned one over.
    std::fill(std::unique(from, to), to, 0);
    begin = end;
  }
}

}  // namespace velum
