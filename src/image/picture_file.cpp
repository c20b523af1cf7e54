#include "picture_file.hpp"

#include <cstring>
#include <limits>
#include <string_view>

#include "../base/error.hpp"
#include "png.hpp"
#include "ppm.hpp"
#include "stb_pictures.hpp"

namespace velum {
namespace {

[[noreturn]] void fail(const std::string& name, const std::string& problem) {
  throw Error(ErrorKind::read, problem, name, "save it as PNG");
}

bool begins_with(std::span<const std::byte> bytes, std::string_view mark) {
  return bytes.size() >= mark.size() && std::memcmp(bytes.data(), mark.data(), mark.size()) == 0;
}

bool ends_with_tga(const std::string& name) {
  if (name.size() < 4) return false;
  std::string extension = name.substr(name.size() - 4);
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension == ".tga";
}

/// A PNG's compressed data tell more exactly what they can hold: decode_png() asks them.
void check_size(std::span<const std::byte> bytes, const std::string& name, std::uint64_t most_pixels,
                bool is_png) {
  const stb::Size size = stb::announced_size(bytes);
  if (size.width <= 0 || size.height <= 0) fail(name, "not a readable picture");
  const auto width = static_cast<std::uint64_t>(size.width), height = static_cast<std::uint64_t>(size.height);
  if (size.width > max_image_side || size.height > max_image_side || width * height > most_pixels) {
    fail(name, "the picture is too large: " + std::to_string(width) + "x" + std::to_string(height));
  }
  if (!is_png && width * height > 1024 * static_cast<std::uint64_t>(bytes.size()))
    fail(name, "the header announces more pixels than the file can hold");
}

/// Whether every Huffman table in a JPEG has at most 256 codes and stands in its segment (ITU-T T.81,
/// B.2.4.2): stb_image 2.27 writes beyond its tables otherwise. Looks wherever a table could begin; in
/// picture data the marker cannot occur.
bool has_sound_tables(std::span<const std::byte> jpeg) {
  const auto at = [&](std::size_t i) { return std::to_integer<std::size_t>(jpeg[i]); };
  for (std::size_t i = 0; i + 4 <= jpeg.size(); ++i) {
    if (at(i) != 0xff || at(i + 1) != 0xc4) continue;
    const std::size_t length = at(i + 2) << 8 | at(i + 3);
    if (length < 2 || length > jpeg.size() - i - 2) return false;
    std::size_t left = length - 2;
    for (std::size_t table = i + 4; left > 0;) {
      if (left < 17) return false;
      std::size_t codes = 0;
      for (std::size_t k = 1; k <= 16; ++k) codes += at(table + k);
      if (codes > 256 || codes > left - 17) return false;
      table += 17 + codes;
      left -= 17 + codes;
    }
  }
  return true;
}

Image<Rgba8> decode_with_stb(std::span<const std::byte> bytes, const std::string& name) {
  const stb::Decoded decoded = stb::decode(bytes);
  if (decoded.rgba == nullptr) fail(name, std::string("not a readable picture: ") + decoded.problem);
  Image<Rgba8> image(decoded.width, decoded.height);
  const std::size_t row_bytes = static_cast<std::size_t>(decoded.width) * sizeof(Rgba8);
  for (int y = 0; y < decoded.height; ++y)
    std::memcpy(image.row(y), decoded.rgba.get() + static_cast<std::size_t>(y) * row_bytes, row_bytes);
  return image;
}

}  // namespace

Image<Rgba8> decode_picture(std::span<const std::byte> bytes, const std::string& name,
                            std::uint64_t most_pixels) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) fail(name, "over 2 GiB");
  if (begins_with(bytes, "P6")) {
    if (bytes.size() / 3 > most_pixels) fail(name, "the picture is too large");
    return decode_ppm(bytes, name);
  }
  const bool is_png = begins_with(bytes, "\x89PNG"), is_jpeg = begins_with(bytes, "\xff\xd8\xff");
  if (!is_png && !is_jpeg && !begins_with(bytes, "BM") && !ends_with_tga(name))
    fail(name, "no picture format that is known: PNG, JPEG, BMP, TGA and PPM (P6) are");
  if (is_jpeg && !has_sound_tables(bytes)) fail(name, "not a readable JPEG: a code table is broken");
  check_size(bytes, name, most_pixels, is_png);
  return is_png ? decode_png(bytes, name) : decode_with_stb(bytes, name);
}

}  // namespace velum
