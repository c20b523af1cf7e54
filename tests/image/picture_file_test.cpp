#include <doctest/doctest.h>

#include "base/error.hpp"
#include "image/picture_file.hpp"
#include "pictures.hpp"

using namespace velum;
using pictures::Bytes;

namespace {

constexpr std::uint64_t plenty = 1 << 20;

std::string little_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i));
  return text;
}

/// 24 bits, rows from below, padded to four bytes.
Bytes bmp(int width, int height, const std::string& rows) {
  const auto size = static_cast<std::uint32_t>(54 + rows.size());
  return pictures::bytes("BM" + little_endian(size, 4) + little_endian(0, 4) + little_endian(54, 4) +
                         little_endian(40, 4) + little_endian(static_cast<std::uint32_t>(width), 4) +
                         little_endian(static_cast<std::uint32_t>(height), 4) + little_endian(1, 2) +
                         little_endian(24, 2) + little_endian(0, 4) +
                         little_endian(static_cast<std::uint32_t>(rows.size()), 4) + std::string(16, '\0') +
                         rows);
}

/// Uncompressed true colour, rows from above.
Bytes tga(int width, int height, const std::string& pixels) {
  using namespace std::string_literals;
  return pictures::bytes("\0\0\x02\0\0\0\0\0\0\0\0\0"s + little_endian(static_cast<std::uint32_t>(width), 2) +
                         little_endian(static_cast<std::uint32_t>(height), 2) + "\x18\x20"s + pixels);
}

/// A whole JPEG: 8x8 pixels of one grey; `codes` of the first Huffman table, whose only code is one bit long.
Bytes jpeg(const std::string& codes = std::string("\x01", 1) + std::string(15, '\0'),
           const std::string& values = std::string(1, '\0')) {
  using namespace std::string_literals;
  const std::string quantisation = "\xff\xdb\0\x43\0"s + std::string(64, '\x08');
  const std::string frame = "\xff\xc0\0\x0b\x08\0\x08\0\x08\x01\x01\x11\0"s;
  const auto length = static_cast<char>(19 + values.size());
  const std::string dc = "\xff\xc4\0"s + length + '\0' + codes + values;
  const std::string ac = "\xff\xc4\0\x14\x10\x01"s + std::string(15, '\0') + '\0';
  return pictures::bytes("\xff\xd8"s + quantisation + frame + dc + ac + "\xff\xda\0\x08\x01\x01\0\0\x3f\0"s +
                         "\x3f\xff\xd9"s);
}

}  // namespace

TEST_CASE("pictures are known by their content") {
  using namespace std::string_literals;
  const Image<Rgba8> noise = pictures::noise(5, 4, true);
  for (const Bytes& file : {encode_png(noise), encode_ppm(noise)}) {
    const Image<Rgba8> read = decode_picture(file, "anything.jpg", plenty);
    REQUIRE(read.width() == 5);
    REQUIRE(read.height() == 4);
    CHECK(read.at(3, 2) == noise.at(3, 2));
  }
  const Image<Rgba8> from_bmp = decode_picture(bmp(1, 2, "\x03\x02\x01\0\x30\x20\x10\0"s), "a", plenty);
  CHECK(from_bmp.at(0, 0) == Rgba8{0x10, 0x20, 0x30, 255});
  CHECK(from_bmp.at(0, 1) == Rgba8{1, 2, 3, 255});
  const Image<Rgba8> from_tga = decode_picture(tga(1, 2, "\x03\x02\x01\x30\x20\x10"s), "sub/A.TGA", plenty);
  CHECK(from_tga.at(0, 0) == Rgba8{1, 2, 3, 255});
  CHECK(from_tga.at(0, 1) == Rgba8{0x10, 0x20, 0x30, 255});
  const Image<Rgba8> from_jpeg = decode_picture(jpeg(), "a", plenty);
  CHECK(from_jpeg.width() == 8);
  CHECK(from_jpeg.at(7, 7) == Rgba8{128, 128, 128, 255});
}

TEST_CASE("what is no picture, too large, or announces too much is refused") {
  using namespace std::string_literals;
  const auto refused = [](const Bytes& file, const std::string& name, const char* reason,
                          std::uint64_t most = plenty) {
    CHECK_THROWS_WITH_AS(decode_picture(file, name, most), doctest::Contains(reason), Error);
  };
  refused(pictures::bytes("GIF89a and so on"), "a.gif", "a.gif: no picture format that is known");
  refused({}, "empty.png", "no picture format that is known");
  refused(pictures::bytes("too short"), "a.tga", "not a readable picture");
  refused(encode_png(pictures::noise(5, 4, true)), "a.png", "the picture is too large: 5x4", 19);
  refused(encode_ppm(pictures::noise(50, 4, true)), "a.ppm", "the picture is too large", 19);
  refused(tga(32769, 1, ""), "a.tga", "the picture is too large: 32769x1");
  refused(tga(1000, 1000, ""), "a.tga", "more pixels than the file can hold");
}

TEST_CASE("a JPEG whose code tables overflow is refused before it is decoded") {
  const std::string too_many = std::string("\xff\xff", 2) + std::string(14, '\0');
  CHECK_THROWS_WITH_AS(decode_picture(jpeg(too_many, std::string(200, '\0')), "a.jpg", plenty),
                       doctest::Contains("a code table is broken"), Error);
}

TEST_CASE("mutated JPEG, BMP and TGA files are read or refused, never worse") {
  using namespace std::string_literals;
  const std::pair<Bytes, const char*> files[] = {{jpeg(), "a.jpg"},
                                                 {bmp(2, 2, std::string(16, '\x55')), "a.bmp"},
                                                 {tga(3, 2, std::string(18, '\x55')), "a.tga"}};
  Random random{5};
  for (const auto& [file, name] : files) {
    int read = 0;
    for (int i = 0; i < 1000; ++i) {
      Bytes changed = file;
      for (int k = 0; k <= random.below(3); ++k)
        changed[random.next() % changed.size()] = static_cast<std::byte>(random.next());
      if (random.below(4) == 0) changed.resize(random.next() % changed.size());
      try {
        decode_picture(changed, name, plenty);
        ++read;
      } catch (const Error& error) {
        CHECK(error.kind() == ErrorKind::read);
      }
    }
    CHECK(read > 0);
    CHECK(read < 1000);
  }
}
