#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "image/files.hpp"
#include "random.hpp"

/// Small pictures and hand-made PNG files for the tests of the formats.
namespace pictures {

using Bytes = std::vector<std::byte>;

inline velum::Image<velum::Rgba8> noise(int width, int height, bool opaque, std::uint64_t seed = 1) {
  Random random{seed};
  velum::Image<velum::Rgba8> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint64_t bits = random.next();
      image.at(x, y) = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                        static_cast<std::uint8_t>(bits >> 16),
                        opaque ? std::uint8_t{255} : static_cast<std::uint8_t>(bits >> 24)};
    }
  }
  return image;
}

inline Bytes bytes(std::string_view text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

inline std::string text(const Bytes& from) {
  return {reinterpret_cast<const char*>(from.data()), from.size()};
}

inline std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

inline std::string chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
         big_endian(velum::png_checksum(bytes(type + data)));
}

/// A zlib stream of one stored block. @pre fewer than 65536 bytes
inline std::string stored(const std::string& data) {
  const auto size = static_cast<std::uint16_t>(data.size());
  const auto inverse = static_cast<std::uint16_t>(~size);
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return std::string("\x78\x01\x01", 3) + static_cast<char>(size) + static_cast<char>(size >> 8) +
         static_cast<char>(inverse) + static_cast<char>(inverse >> 8) + data + big_endian(b << 16 | a);
}

/// @param rows  filter byte and samples of each row; @param before_data further chunks (PLTE, tRNS)
inline Bytes png(std::uint32_t width, std::uint32_t height, char depth, char type, const std::string& rows,
                 const std::string& before_data = {}) {
  const std::string header = big_endian(width) + big_endian(height) + depth + type + std::string(3, '\0');
  return bytes("\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + before_data + chunk("IDAT", stored(rows)) +
               chunk("IEND", ""));
}

}  // namespace pictures
