#include "npy.hpp"

#include <string>

#include "bytes.hpp"
#include "file_bytes.hpp"

namespace velum {
namespace {

/// Magic, version 1.0, the dictionary's length, and the dictionary padded so that the data begin at 64·n.
std::vector<std::byte> header(const char* type, const std::string& shape) {
  constexpr std::size_t preamble = 10;
  std::string dictionary =
      std::string("{'descr': '") + type + "', 'fortran_order': False, 'shape': (" + shape + "), }";
  const std::size_t unpadded = preamble + dictionary.size() + 1;
  dictionary.append((64 - unpadded % 64) % 64, ' ');
  dictionary += '\n';

  std::string text("\x93NUMPY\x01\x00", 8);
  text += static_cast<char>(dictionary.size() & 0xff);
  text += static_cast<char>(dictionary.size() >> 8);
  return bytes_from(text + dictionary);
}

/// @param words true: the pixel consists of 4-byte words whose byte order counts; false: of bytes
template <typename Pixel>
std::vector<std::byte> encode(ImageView<const Pixel> image, const char* type, const char* channels,
                              bool words) {
  VELUM_REQUIRE(!image.is_empty(), {"width", image.width}, {"height", image.height});
  static_assert(sizeof(Pixel) % 4 == 0);
  std::vector<std::byte> bytes =
      header(type, std::to_string(image.height) + ", " + std::to_string(image.width) + channels);
  const std::size_t row_bytes = static_cast<std::size_t>(image.width) * sizeof(Pixel);
  std::size_t at = bytes.size();
  bytes.resize(at + row_bytes * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y, at += row_bytes) {
    if (words) {
      copy_little_endian(&bytes[at], image.row(y), row_bytes / 4);
    } else {
      std::memcpy(&bytes[at], image.row(y), row_bytes);
    }
  }
  return bytes;
}

}  // namespace

std::vector<std::byte> encode_npy(ImageView<const float> image) {
  return encode(image, "<f4", "", true);
}
std::vector<std::byte> encode_npy(ImageView<const std::uint32_t> image) {
  return encode(image, "<u4", "", true);
}
std::vector<std::byte> encode_npy(ImageView<const glm::vec3> image) {
  return encode(image, "<f4", ", 3", true);
}
std::vector<std::byte> encode_npy(ImageView<const Rgba8> image) {
  return encode(image, "|u1", ", 4", false);
}

void write_npy(const std::filesystem::path& path, ImageView<const float> image) {
  write_file(path, encode_npy(image));
}
void write_npy(const std::filesystem::path& path, ImageView<const std::uint32_t> image) {
  write_file(path, encode_npy(image));
}
void write_npy(const std::filesystem::path& path, ImageView<const glm::vec3> image) {
  write_file(path, encode_npy(image));
}
void write_npy(const std::filesystem::path& path, ImageView<const Rgba8> image) {
  write_file(path, encode_npy(image));
}

}  // namespace velum
