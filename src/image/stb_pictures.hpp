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

struct Size {
  int width = 0;
  int height = 0;
};
/// What the header says, before anything is decoded; 0 for what is no picture. @pre file.size() < 2³¹
Size announced_size(std::span<const std::byte> file);

struct Decoded {
  std::unique_ptr<unsigned char, void (*)(void*)> rgba;  ///< width·height·4 bytes; null on failure
  int width = 0;
  int height = 0;
  const char* problem = "";  ///< stb's reason on failure
};
/// PNG, JPEG, BMP or TGA, by content. @pre file.size() < 2³¹
Decoded decode(std::span<const std::byte> file);

}  // namespace velum::stb
