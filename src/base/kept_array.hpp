#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

namespace velum {

/// Memory for an array that is filled again and again: it grows, never shrinks, and what is in it is not
/// initialized.
template <typename T>
class KeptArray {
 public:
  /// Makes room for at least `count` elements; the first `kept` keep their values. Where some are kept it
  /// makes more, so that appending one by one copies each a few times only.
  T* make_room(std::size_t count, std::size_t kept = 0) {
    if (count > room_) {
      if (kept > 0) count = std::max(count, room_ + room_ / 2);
      std::unique_ptr<T[]> more(new T[count]);
      std::copy_n(elements_.get(), kept, more.get());
      elements_ = std::move(more);
      room_ = count;
    }
    return elements_.get();
  }
  /// For how many elements there is room.
  std::size_t room() const { return room_; }
  T* data() { return elements_.get(); }
  const T* data() const { return elements_.get(); }
  T& operator[](std::size_t i) { return elements_[i]; }
  const T& operator[](std::size_t i) const { return elements_[i]; }

 private:
  std::unique_ptr<T[]> elements_;
  std::size_t room_ = 0;
};

}  // namespace velum
