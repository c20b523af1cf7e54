#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>
#include <vector>

namespace velum {

/// A header's text, as the beginning of a file.
inline std::vector<std::byte> bytes_from(std::string_view text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

/// Copies count words of 4 bytes, byte order reversed or not.
inline void copy_words(std::byte* to, const std::byte* from, std::size_t count, bool reverse) {
  std::memcpy(to, from, count * 4);
  if (!reverse) return;
  for (std::size_t i = 0; i < count; ++i) std::reverse(to + 4 * i, to + 4 * i + 4);
}

/// Between this machine's byte order and little-endian, either way. @param count words of 4 bytes
inline void copy_little_endian(void* to, const void* from, std::size_t count) {
  copy_words(static_cast<std::byte*>(to), static_cast<const std::byte*>(from), count,
             std::endian::native != std::endian::little);
}

/// Between this machine's byte order and big-endian, either way. @param count words of 4 bytes
inline void copy_big_endian(void* to, const void* from, std::size_t count) {
  copy_words(static_cast<std::byte*>(to), static_cast<const std::byte*>(from), count,
             std::endian::native != std::endian::big);
}

}  // namespace velum
