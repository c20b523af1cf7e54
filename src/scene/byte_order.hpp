#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace velum {

/// An integer from bytes of the given order, at any address.
template <typename Integer>
Integer load_integer(const std::byte* bytes, std::endian order) {
  using Unsigned = std::make_unsigned_t<Integer>;
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Integer); ++i) {
    const std::size_t place = order == std::endian::little ? i : sizeof(Integer) - 1 - i;
    value = static_cast<Unsigned>(value |
                                  static_cast<Unsigned>(std::to_integer<Unsigned>(bytes[i]) << 8 * place));
  }
  return static_cast<Integer>(value);
}

/// IEEE binary32 and binary64 from bytes of the given order.
inline float load_float(const std::byte* bytes, std::endian order) {
  return std::bit_cast<float>(load_integer<std::uint32_t>(bytes, order));
}
inline double load_double(const std::byte* bytes, std::endian order) {
  return std::bit_cast<double>(load_integer<std::uint64_t>(bytes, order));
}

}  // namespace velum
