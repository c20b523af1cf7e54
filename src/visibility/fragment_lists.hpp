#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "../base/rect.hpp"
#include "../image/visibility_buffer.hpp"

namespace velum {

/// (depth, id) as one whole number, larger for what is seen before. Depths are never negative, so their bits
/// are in the order of their values. The background has 0.
constexpr std::uint64_t nearness(float reversed_depth, std::uint32_t primitive) {
  return (std::uint64_t{std::bit_cast<std::uint32_t>(reversed_depth)} << 32) | (no_primitive - primitive);
}
constexpr float reversed_depth_of(std::uint64_t nearness) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(nearness >> 32));
}
constexpr std::uint32_t primitive_of(std::uint64_t nearness) {
  return no_primitive - static_cast<std::uint32_t>(nearness);
}

/// All fragments behind a first layer, pixel by pixel in the order in which they are seen: the lists of the
/// A-buffer (Carpenter 1984, "The A-buffer, an antialiased hidden surface method"), sorted over (depth, id)
/// and without its coverage masks. A list holds what depth peeling would find layer after layer, for two
/// passes over the triangles instead of one per layer.
///
/// begin_counting, the triangles; then for each of parts(): begin_storing, the triangles, sort. The parts are
/// there to bound the memory.
class FragmentLists {
 public:
  /// @param front  the first layer of the pixels of `rect`; only what is behind it is kept, so that nothing
  ///               is where it shows the background. Must live and stay as it is while fragments are added
  /// @param wanted  the part of `rect` in which fragments are counted; add() must not go beyond
  void begin_counting(const VisibilityBuffer& front, const Rect& rect, const Rect& wanted);

  /// Rectangles that together are `wanted`, from top to bottom, each with at most `most` fragments or a
  /// single pixel. They stay until the next call.
  const std::vector<Rect>& parts(std::uint64_t most);

  /// How many there are in a row of `wanted`, picture coordinates. @pre counted
  std::uint64_t count_of_row(int y) const;

  /// @pre part is one of parts(), or any rectangle in `wanted` with fewer than 2³² fragments
  void begin_storing(const Rect& part);

  /// Picture coordinates. @pre (x, y) in the part, or while counting in `wanted`
  void add(int x, int y, float reversed_depth, std::uint32_t primitive) {
    const std::uint64_t fragment = nearness(reversed_depth, primitive);
    if (fragment >= front_at(x - rect_.left, y - rect_.top)) return;
    if (is_counting_) {
      ++counts_.at(x - wanted_.left, y - wanted_.top);
    } else {
      fragments_[ends_[place(x, y)]++] = fragment;
    }
  }

  /// Puts the lists in order, each fragment once.
  void sort();

  /// The nearness of the fragments behind the first layer, nearest first; 0 from where there are no more.
  /// @pre sorted; (x, y) in the part, picture coordinates
  std::span<const std::uint64_t> at(int x, int y) const {
    const std::size_t i = place(x, y);
    const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
    return {fragments_.data() + begin, ends_[i] - begin};
  }

 private:
  std::uint64_t front_at(int column, int row) const {
    return nearness(front_->reversed_depth.at(column, row), front_->primitive.at(column, row));
  }
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y - part_.top) * static_cast<std::size_t>(part_.width) +
           static_cast<std::size_t>(x - part_.left);
  }

  const VisibilityBuffer* front_ = nullptr;
  Rect rect_, wanted_, part_;
  bool is_counting_ = false;
  Image<std::uint32_t> counts_;  // of wanted_
  std::vector<Rect> parts_;
  std::vector<std::uint32_t> ends_;       // per pixel of part_; its list's begin until it is filled
  std::vector<std::uint64_t> fragments_;  // of part_
};

}  // namespace velum
