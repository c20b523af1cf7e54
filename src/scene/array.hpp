#pragma once

#include <cstddef>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace velum {

/// A read-only array that either owns its elements or views the caller's without a copy.
/// Copying one is cheap: owners share their elements, views stay views (the caller keeps the memory alive).
template <typename T>
class Array {
 public:
  Array() = default;
  /// Takes the elements over.
  Array(std::vector<T> elements)
      : owned_(std::make_shared<const std::vector<T>>(std::move(elements))), view_(*owned_) {}
  Array(std::initializer_list<T> elements) : Array(std::vector<T>(elements)) {}
  /// Views the caller's elements; they must outlive every use of this array and not change meanwhile.
  static Array viewing(std::span<const T> elements) {
    Array result;
    result.view_ = elements;
    return result;
  }

  std::size_t size() const { return view_.size(); }
  bool empty() const { return view_.empty(); }
  const T& operator[](std::size_t i) const { return view_[i]; }
  const T* data() const { return view_.data(); }
  const T* begin() const { return view_.data(); }
  const T* end() const { return view_.data() + view_.size(); }
  std::span<const T> span() const { return view_; }
  bool is_owner() const { return owned_ != nullptr; }

 private:
  std::shared_ptr<const std::vector<T>> owned_;
  std::span<const T> view_;
};

}  // namespace velum
