#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

/// The only door to stb_image and stb_image_write: plain bytes in and out, no policy.
namespace velum::stb {

/// @param pixels width·height·channels bytes without padding, top row first
/// @return the file; empty when memory ran out
std::vector<std::byte> encode_png(const unsigned char* pixels, int width, int height, int channels);

struct Decoded {
  std::unique_ptr<unsigned char, void (*)(void*)> rgba;  ///< width·height·4 bytes; null on failure
  int width = 0;
  int height = 0;
  const char* problem = "";  ///< stb's reason on failure
};
Decoded decode_png(std::span<const std::byte> file);

}  // namespace velum::stb
