#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../base/contract.hpp"
#include "cache_line_allocator.hpp"

namespace velum {

/// The largest width and height of any picture, in pixels. Readers refuse more.
inline constexpr int max_image_side = 32768;

/// A window on pixels that somebody else owns: row y starts at data + y·stride (stride in elements, ≥ width).
/// Row 0 is the top row. A default view is empty: data == nullptr.
template <typename T>
struct ImageView {
  T* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;

  bool is_empty() const { return data == nullptr || width <= 0 || height <= 0; }
  T* row(int y) const { return data + static_cast<std::ptrdiff_t>(y) * stride; }
  T& at(int x, int y) const { return row(y)[x]; }
  operator ImageView<const T>() const { return {data, width, height, stride}; }
};

/// A picture that owns its pixels; rows begin at multiples of 64 bytes. Row 0 is the top row.
template <typename T>
class Image {
 public:
  Image() = default;

  /// @pre width ≥ 0, height ≥ 0
  Image(int width, int height, const T& value = T{}) { resize(width, height, value); }

  /// Sets the size and every pixel to value; keeps the memory where it suffices.
  void resize(int width, int height, const T& value = T{}) {
    VELUM_REQUIRE(width >= 0 && height >= 0, {"width", width}, {"height", height});
    width_ = width;
    height_ = height;
    stride_ = padded(width);
    pixels_.assign(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height), value);
  }

  /// Sets the size; the pixels have any values. Keeps the memory where it suffices.
  void reshape(int width, int height) {
    VELUM_REQUIRE(width >= 0 && height >= 0, {"width", width}, {"height", height});
    width_ = width;
    height_ = height;
    stride_ = padded(width);
    pixels_.resize(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height));
  }

  /// The memory that a picture of this size takes, with its padding.
  static std::uint64_t bytes_for(int width, int height) {
    return static_cast<std::uint64_t>(padded(width)) * static_cast<std::uint64_t>(height) * sizeof(T);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  std::ptrdiff_t stride() const { return stride_; }
  bool is_empty() const { return width_ == 0 || height_ == 0; }

  /// @pre 0 ≤ y < height()
  T* row(int y) { return pixels_.data() + static_cast<std::ptrdiff_t>(y) * stride_; }
  const T* row(int y) const { return pixels_.data() + static_cast<std::ptrdiff_t>(y) * stride_; }

  /// @pre 0 ≤ x < width(), 0 ≤ y < height(); not checked
  T& at(int x, int y) { return row(y)[x]; }
  const T& at(int x, int y) const { return row(y)[x]; }

  void fill(const T& value) { std::fill(pixels_.begin(), pixels_.end(), value); }

  ImageView<T> view() { return {pixels_.data(), width_, height_, stride_}; }
  ImageView<const T> view() const { return {pixels_.data(), width_, height_, stride_}; }
  operator ImageView<const T>() const { return view(); }

 private:
  static std::ptrdiff_t padded(int width) {
    constexpr std::ptrdiff_t unit =
        sizeof(T) >= 64 || 64 % sizeof(T) != 0 ? 16 : 64 / static_cast<std::ptrdiff_t>(sizeof(T));
    return (width + unit - 1) / unit * unit;
  }

  int width_ = 0;
  int height_ = 0;
  std::ptrdiff_t stride_ = 0;
  std::vector<T, CacheLineAllocator<T>> pixels_;
};

}  // namespace velum
