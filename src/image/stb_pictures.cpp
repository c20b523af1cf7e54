#include "stb_pictures.hpp"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // of a stream kind that is not compiled in
#endif
#endif

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_SIMD  // the same code, so the same bytes, on every machine
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_NO_STDIO
#include <stb_image.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace velum::stb {

std::vector<std::byte> encode_png(const unsigned char* pixels, int width, int height, int channels) {
  std::vector<std::byte> file;
  const auto append = [](void* context, void* data, int size) {
    const auto* first = static_cast<const std::byte*>(data);
    static_cast<std::vector<std::byte>*>(context)->assign(first, first + size);
  };
  stbi_write_png_to_func(append, &file, width, height, channels, pixels, width * channels);
  return file;
}

Size announced_size(std::span<const std::byte> file) {
  Size size;
  int channels = 0;
  if (stbi_info_from_memory(reinterpret_cast<const unsigned char*>(file.data()),
                            static_cast<int>(file.size()), &size.width, &size.height, &channels) == 0)
    return {};
  return size;
}

Decoded decode(std::span<const std::byte> file) {
  Decoded decoded{{nullptr, stbi_image_free}};
  int channels = 0;
  decoded.rgba.reset(stbi_load_from_memory(reinterpret_cast<const unsigned char*>(file.data()),
                                           static_cast<int>(file.size()), &decoded.width, &decoded.height,
                                           &channels, 4));
  if (decoded.rgba == nullptr) decoded.problem = stbi_failure_reason();
  return decoded;
}

}  // namespace velum::stb
