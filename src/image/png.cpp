#include "png.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#include "../base/error.hpp"
#include "file_bytes.hpp"
#include "stb_pictures.hpp"

namespace velum {
namespace {

constexpr std::array<unsigned char, 8> signature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t header_end = 33;  // signature, then the IHDR chunk: 4 + 4 + 13 + 4

/// An sRGB chunk, perceptual intent, ready with length and checksum (PNG specification, 11.3.2.5).
constexpr std::array<unsigned char, 13> srgb_chunk = {0,   0, 0,    1,    's',  'R', 'G',
                                                      'B', 0, 0xae, 0xce, 0x1c, 0xe9};

[[noreturn]] void fail_to_read(const std::string& name, const std::string& problem) {
  throw Error(ErrorKind::read, "not a readable PNG: " + problem, name,
              "save the picture again, or convert it with another program");
}

std::uint32_t big_endian_32(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return value;
}

bool is_opaque(ImageView<const Rgba8> image) {
  for (int y = 0; y < image.height; ++y) {
    const Rgba8* row = image.row(y);
    if (std::any_of(row, row + image.width, [](const Rgba8& pixel) { return pixel.a != 255; })) return false;
  }
  return true;
}

/// Rows without padding, three or four bytes a pixel.
std::vector<unsigned char> pack(ImageView<const Rgba8> image, std::size_t channels) {
  std::vector<unsigned char> bytes;
  bytes.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * channels);
  unsigned char* to = bytes.data();
  for (int y = 0; y < image.height; ++y) {
    const Rgba8* row = image.row(y);
    for (int x = 0; x < image.width; ++x, to += channels) std::memcpy(to, &row[x], channels);
  }
  return bytes;
}

/// Every chunk stands wholly in the file with the right checksum, and IEND comes last. stb_image checks
/// neither.
/// @return the bytes of compressed picture data
std::size_t check_chunks(std::span<const std::byte> file, const std::string& name) {
  std::size_t picture_data = 0;
  std::size_t at = signature.size();
  while (true) {
    if (file.size() - at < 12) fail_to_read(name, "the file ends early");
    const std::size_t length = big_endian_32(file, at);
    if (length > file.size() - at - 12) fail_to_read(name, "a chunk is longer than the file");
    const auto type = file.subspan(at + 4, 4);
    if (png_checksum(file.subspan(at + 4, 4 + length)) != big_endian_32(file, at + 8 + length)) {
      fail_to_read(name, "a checksum is wrong");
    }
    at += 12 + length;
    if (std::memcmp(type.data(), "IDAT", 4) == 0) picture_data += length;
    if (std::memcmp(type.data(), "IEND", 4) == 0) return picture_data;
  }
}

/// Refuses a header that announces more than the compressed data can hold, before anything is allocated for
/// it.
void check_header(std::span<const std::byte> file, std::size_t picture_data, const std::string& name) {
  const std::uint64_t width = big_endian_32(file, 16);
  const std::uint64_t height = big_endian_32(file, 20);
  if (width == 0 || height == 0 || width > max_image_side || height > max_image_side) {
    fail_to_read(name, "its size is " + std::to_string(width) + "x" + std::to_string(height) +
                           " where 1 to 32768 pixels a side are allowed");
  }
  constexpr std::array<std::uint64_t, 7> channels_of_type = {1, 0, 3, 1, 2, 0, 4};
  const auto depth = std::to_integer<std::uint64_t>(file[24]);
  const auto type = std::to_integer<std::size_t>(file[25]);
  if (type >= channels_of_type.size() || channels_of_type[type] == 0)
    fail_to_read(name, "unknown colour type");
  const std::uint64_t row_bytes = (width * channels_of_type[type] * depth + 7) / 8 + 1;
  // Deflate yields at most 258 bytes from 2 bits: 1032 to 1 (Gailly & Adler, zlib technical details).
  if (row_bytes * height > 1032 * static_cast<std::uint64_t>(picture_data) + 1032) {
    fail_to_read(name, "the header announces " + std::to_string(width) + "x" + std::to_string(height) +
                           " pixels, more than the file can hold");
  }
}

}  // namespace

unsigned png_checksum(std::span<const std::byte> bytes) {
  static constexpr std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t entry = i;
      for (int bit = 0; bit < 8; ++bit) entry = (entry & 1u) != 0 ? 0xedb88320u ^ entry >> 1 : entry >> 1;
      entries[i] = entry;
    }
    return entries;
  }();
  std::uint32_t checksum = 0xffffffffu;
  for (const std::byte byte : bytes) {
    checksum = table[(checksum ^ std::to_integer<std::uint32_t>(byte)) & 0xffu] ^ checksum >> 8;
  }
  return ~checksum;
}

std::vector<std::byte> encode_png(ImageView<const Rgba8> image) {
  VELUM_REQUIRE(!image.is_empty(), {"width", image.width}, {"height", image.height});
  const int channels = is_opaque(image) ? 3 : 4;
  const std::uint64_t size = static_cast<std::uint64_t>(image.width) *
                             static_cast<std::uint64_t>(image.height) * (channels == 3 ? 3 : 4);
  if (size > largest_png_bytes) {  // stb counts in int, doubles its output buffer, and reads no more back
    throw Error(ErrorKind::limit, "the picture is too large for PNG", "",
                "write PPM or NPY, or make it smaller");
  }
  const std::vector<unsigned char> pixels = pack(image, static_cast<std::size_t>(channels));
  std::vector<std::byte> file = stb::encode_png(pixels.data(), image.width, image.height, channels);
  if (file.size() < header_end) throw Error(ErrorKind::limit, "not enough memory for a PNG");
  const auto* chunk = reinterpret_cast<const std::byte*>(srgb_chunk.data());
  file.insert(file.begin() + header_end, chunk, chunk + srgb_chunk.size());
  return file;
}

Image<Rgba8> decode_png(std::span<const std::byte> bytes, const std::string& name) {
  if (bytes.size() < signature.size() || std::memcmp(bytes.data(), signature.data(), signature.size()) != 0) {
    fail_to_read(name, "it does not begin as one");
  }
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    fail_to_read(name, "over 2 GiB");
  if (bytes.size() < header_end || big_endian_32(bytes, 8) != 13 || std::memcmp(&bytes[12], "IHDR", 4) != 0) {
    fail_to_read(name, "the header is missing");
  }
  check_header(bytes, check_chunks(bytes, name), name);

  const stb::Decoded decoded = stb::decode(bytes);
  if (decoded.rgba == nullptr) fail_to_read(name, decoded.problem);
  Image<Rgba8> image(decoded.width, decoded.height);
  const std::size_t row_bytes = static_cast<std::size_t>(decoded.width) * 4;
  static_assert(sizeof(Rgba8) == 4);
  for (int y = 0; y < decoded.height; ++y) {
    std::memcpy(image.row(y), decoded.rgba.get() + static_cast<std::size_t>(y) * row_bytes, row_bytes);
  }
  return image;
}

void write_png(const std::filesystem::path& path, ImageView<const Rgba8> image) {
  write_file(path, encode_png(image));
}

Image<Rgba8> read_png(const std::filesystem::path& path) {
  return decode_png(read_file(path), input_name(path));
}

}  // namespace velum
