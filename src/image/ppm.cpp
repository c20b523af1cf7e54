#include "ppm.hpp"

#include "bytes.hpp"
#include "file_bytes.hpp"
#include "netpbm_header.hpp"

namespace velum {

std::vector<std::byte> encode_ppm(ImageView<const Rgba8> image) {
  VELUM_REQUIRE(!image.is_empty(), {"width", image.width}, {"height", image.height});
  std::vector<std::byte> bytes =
      bytes_from("P6\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n");
  std::size_t at = bytes.size();
  bytes.resize(at + static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3);
  for (int y = 0; y < image.height; ++y) {
    const Rgba8* row = image.row(y);
    for (int x = 0; x < image.width; ++x) {
      bytes[at++] = std::byte{row[x].r};
      bytes[at++] = std::byte{row[x].g};
      bytes[at++] = std::byte{row[x].b};
    }
  }
  return bytes;
}

Image<Rgba8> decode_ppm(std::span<const std::byte> bytes, const std::string& name) {
  NetpbmHeader header(bytes, "PPM", name);
  if (header.word() != "P6") header.fail("it does not begin with P6");
  const int width = header.side();
  const int height = header.side();
  if (header.word() != "255") header.fail("its largest value is not 255, as 8-bit pictures have it");

  const std::byte* from = header.payload(height, static_cast<std::size_t>(width) * 3);
  Image<Rgba8> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x, from += 3) {
      image.at(x, y) = {std::to_integer<std::uint8_t>(from[0]), std::to_integer<std::uint8_t>(from[1]),
                        std::to_integer<std::uint8_t>(from[2]), 255};
    }
  }
  return image;
}

void write_ppm(const std::filesystem::path& path, ImageView<const Rgba8> image) {
  write_file(path, encode_ppm(image));
}

Image<Rgba8> read_ppm(const std::filesystem::path& path) {
  return decode_ppm(read_file(path), input_name(path));
}

}  // namespace velum
