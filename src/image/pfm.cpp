#include "pfm.hpp"

#include <fast_float/fast_float.h>

#include "bytes.hpp"
#include "file_bytes.hpp"
#include "netpbm_header.hpp"

namespace velum {
namespace {

static_assert(sizeof(float) == 4 && sizeof(glm::vec3) == 12);

template <typename Pixel>
constexpr const char* magic = sizeof(Pixel) == 4 ? "Pf" : "PF";

template <typename Pixel>
std::vector<std::byte> encode(ImageView<const Pixel> image) {
  VELUM_REQUIRE(!image.is_empty(), {"width", image.width}, {"height", image.height});
  std::vector<std::byte> bytes = bytes_from(std::string(magic<Pixel>) + "\n" + std::to_string(image.width) +
                                            " " + std::to_string(image.height) + "\n-1.0\n");
  const std::size_t row_bytes = static_cast<std::size_t>(image.width) * sizeof(Pixel);
  std::size_t at = bytes.size();
  bytes.resize(at + row_bytes * static_cast<std::size_t>(image.height));
  for (int y = image.height - 1; y >= 0; --y, at += row_bytes) {
    copy_little_endian(&bytes[at], image.row(y), row_bytes / 4);
  }
  return bytes;
}

/// @return true for little-endian
bool read_byte_order(NetpbmHeader& header) {
  const std::string_view text = header.word();
  double scale = 0.0;
  const auto [end, status] = fast_float::from_chars(text.data(), text.data() + text.size(), scale);
  const bool is_number = status == std::errc{} && end == text.data() + text.size();
  if (!is_number || !(scale < 0.0 || scale > 0.0)) header.fail("its scale is not a number other than zero");
  return scale < 0.0;
}

template <typename Pixel>
Image<Pixel> decode(std::span<const std::byte> bytes, const std::string& name) {
  NetpbmHeader header(bytes, "PFM", name);
  if (header.word() != magic<Pixel>) {
    header.fail(std::string("it does not begin with ") + magic<Pixel> + " (Pf: one channel, PF: three)");
  }
  const int width = header.side();
  const int height = header.side();
  const bool is_little_endian = read_byte_order(header);

  const std::size_t row_bytes = static_cast<std::size_t>(width) * sizeof(Pixel);
  const std::byte* from = header.payload(height, row_bytes);
  Image<Pixel> image(width, height);
  for (int y = height - 1; y >= 0; --y, from += row_bytes) {
    (is_little_endian ? copy_little_endian : copy_big_endian)(image.row(y), from, row_bytes / 4);
  }
  return image;
}

}  // namespace

std::vector<std::byte> encode_pfm(ImageView<const float> image) {
  return encode(image);
}
std::vector<std::byte> encode_pfm(ImageView<const glm::vec3> image) {
  return encode(image);
}
Image<float> decode_pfm(std::span<const std::byte> bytes, const std::string& name) {
  return decode<float>(bytes, name);
}
Image<glm::vec3> decode_pfm_rgb(std::span<const std::byte> bytes, const std::string& name) {
  return decode<glm::vec3>(bytes, name);
}

void write_pfm(const std::filesystem::path& path, ImageView<const float> image) {
  write_file(path, encode(image));
}
void write_pfm(const std::filesystem::path& path, ImageView<const glm::vec3> image) {
  write_file(path, encode(image));
}
Image<float> read_pfm(const std::filesystem::path& path) {
  return decode_pfm(read_file(path), input_name(path));
}
Image<glm::vec3> read_pfm_rgb(const std::filesystem::path& path) {
  return decode_pfm_rgb(read_file(path), input_name(path));
}

}  // namespace velum
