#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "../base/kept_array.hpp"

namespace velum {

/// Things sorted roughly from near to far, so that what is drawn first hides much of the rest. The memory is
/// kept from use to use.
/// @tparam Item  has `nearest`, a reversed depth
template <typename Item>
class NearFirst {
 public:
  /// Empties it. @param count  room for as many
  void begin(std::size_t count) {
    make_room(count);
    count_ = 0;
    nearest_ = 0.0f;
    farthest_ = 1.0f;
  }
  /// @pre there is room
  void add(const Item& item) {
    nearest_ = std::max(nearest_, item.nearest);
    farthest_ = std::min(farthest_, item.nearest);
    items_[count_++] = item;
  }
  /// Sorts into buckets of equal extent in depth, about as many as hold `bucket_size` items each.
  void sort(std::size_t bucket_size);

  int buckets() const { return buckets_; }
  /// The items of one, in the order in which they were added. @pre 0 ≤ k < buckets()
  std::span<const Item> bucket(int k) const {
    const auto i = static_cast<std::size_t>(k);
    return {sorted_.data() + first_[i], first_[i + 1] - first_[i]};
  }

  /// For how many there is memory.
  std::size_t room() const { return items_.room(); }
  void make_room(std::size_t count) {
    items_.make_room(count);
    sorted_.make_room(count);
  }

 private:
  static constexpr int most_buckets = 8;

  KeptArray<Item> items_;
  KeptArray<Item> sorted_;
  std::size_t count_ = 0;
  float nearest_ = 0.0f;   ///< of all
  float farthest_ = 1.0f;  ///< the least of what is nearest
  int buckets_ = 0;
  std::array<std::size_t, most_buckets + 1> first_{};
};

template <typename Item>
void NearFirst<Item>::sort(std::size_t bucket_size) {
  buckets_ = static_cast<int>(std::clamp<std::size_t>(count_ / bucket_size, 1, most_buckets));
  const float extent = nearest_ - farthest_;
  const float scale = extent > 0.0f ? static_cast<float>(buckets_) / extent : 0.0f;
  const auto bucket_of = [&](const Item& item) {
    const int k = static_cast<int>((nearest_ - item.nearest) * scale);
    return static_cast<std::size_t>(std::min(k, buckets_ - 1));
  };
  first_ = {};
  for (std::size_t i = 0; i < count_; ++i) ++first_[bucket_of(items_[i])];
  std::size_t sum = 0;
  for (std::size_t& first : first_) first = std::exchange(sum, sum + first);
  // While items are placed, first_[k] moves from the bucket's beginning to its end.
  for (std::size_t i = 0; i < count_; ++i) sorted_[first_[bucket_of(items_[i])]++] = items_[i];
  std::move_backward(first_.begin(), first_.end() - 1, first_.end());
  first_[0] = 0;
}

}  // namespace velum
