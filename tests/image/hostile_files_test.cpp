#include <doctest/doctest.h>

#include <functional>

#include "base/error.hpp"
#include "pictures.hpp"

using namespace velum;
using pictures::Bytes;

namespace {

using Decoder = std::function<void(const Bytes&)>;

struct Format {
  const char* name;
  Bytes file;
  Decoder decode;
};

std::vector<Format> formats() {
  using namespace std::string_literals;
  const auto png = [](const Bytes& bytes) { decode_png(bytes, "mutated"); };
  const auto pfm = [](const Bytes& bytes) { decode_pfm(bytes, "mutated"); };
  const auto pfm_rgb = [](const Bytes& bytes) { decode_pfm_rgb(bytes, "mutated"); };
  const auto ppm = [](const Bytes& bytes) { decode_ppm(bytes, "mutated"); };
  const std::string palette = pictures::chunk("PLTE", "\x01\x02\x03\x0a\x0b\x0c"s);
  return {{"PNG", encode_png(pictures::noise(5, 4, false)), png},
          {"PNG with a palette", pictures::png(5, 2, 1, 3, "\0\x40\0\xf8"s, palette), png},
          {"PPM", encode_ppm(pictures::noise(5, 4, true)), ppm},
          {"PFM", encode_pfm(Image<float>(3, 4, 1.5f)), pfm},
          {"PFM in colour", encode_pfm(Image<glm::vec3>(3, 4, glm::vec3(0.5f))), pfm_rgb}};
}

/// True: read; false: refused with an Error (read). Anything else fails the test.
bool is_read(const Format& format, const Bytes& bytes) {
  try {
    format.decode(bytes);
    return true;
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::read);
    CHECK(std::string(error.what()).substr(0, 9) == "mutated: ");
    return false;
  }
}

/// Puts the right checksum behind every chunk, so that mutations reach the decoder behind that check.
void repair_checksums(Bytes& file) {
  std::size_t at = 8;
  while (at + 12 <= file.size()) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | std::to_integer<std::size_t>(file[at + i]);
    if (length > file.size() - at - 12) return;
    const std::string checksum = pictures::big_endian(png_checksum({&file[at + 4], 4 + length}));
    for (std::size_t i = 0; i < 4; ++i) file[at + 8 + length + i] = static_cast<std::byte>(checksum[i]);
    at += 12 + length;
  }
}

void mutate_and_read(const Format& format, int count, bool repair) {
  Random random{99};
  int read = 0;
  for (int i = 0; i < count; ++i) {
    Bytes bytes = format.file;
    const std::uint64_t changes = 1 + random.next() % 3;
    for (std::uint64_t change = 0; change < changes; ++change) {
      bytes[random.next() % bytes.size()] = static_cast<std::byte>(random.next());
    }
    if (repair) repair_checksums(bytes);
    if (is_read(format, bytes)) ++read;
  }
  CAPTURE(format.name);
  CHECK(read < count);  // some mutation must have been noticed
}

}  // namespace

TEST_CASE("every truncated file is refused") {
  for (const Format& format : formats()) {
    CAPTURE(format.name);
    REQUIRE(is_read(format, format.file));
    for (std::size_t size = 0; size < format.file.size(); ++size) {
      CAPTURE(size);
      CHECK_FALSE(is_read(
          format, Bytes(format.file.begin(), format.file.begin() + static_cast<std::ptrdiff_t>(size))));
    }
  }
}

TEST_CASE("PNG: a change of any one byte is noticed") {
  const Format format = formats().front();
  for (std::size_t i = 0; i < format.file.size(); ++i) {
    Bytes bytes = format.file;
    bytes[i] ^= std::byte{0x10};
    CAPTURE(i);
    CHECK_FALSE(is_read(format, bytes));
  }
}

TEST_CASE("mutated files are read or refused, never worse") {
  for (const Format& format : formats()) mutate_and_read(format, 500, false);
  for (const Format& format : formats()) {
    if (std::string(format.name).substr(0, 3) == "PNG") mutate_and_read(format, 500, true);
  }
}

TEST_CASE("[long] many mutated files are read or refused, never worse") {
  for (const Format& format : formats()) {
    mutate_and_read(format, 20000, std::string(format.name).substr(0, 3) == "PNG");
  }
}

TEST_CASE("a header that announces more than the file can hold is refused before memory is taken") {
  using namespace std::string_literals;
  CHECK_THROWS_WITH_AS(
      decode_ppm(pictures::bytes("P6 32768 32768 255\nabc"), "big.ppm"),
      doctest::Contains("big.ppm: not a readable PPM: the header announces 3221225472 bytes"), Error);
  CHECK_THROWS_WITH_AS(decode_pfm_rgb(pictures::bytes("PF 32768 32768 -1\nabc"), "big.pfm"),
                       doctest::Contains("12884901888 bytes of pixels, but 3 follow"), Error);
  CHECK_THROWS_WITH_AS(decode_png(pictures::png(32768, 32768, 8, 6, "\0abc"s), "big.png"),
                       doctest::Contains("announces 32768x32768 pixels, more than the file can hold"), Error);
}

TEST_CASE("sizes outside 1 to 32768 and other unusable headers are refused") {
  using namespace std::string_literals;
  for (const char* text : {"P6 0 1 255\nabc", "P6 1 0 255\nabc", "P6 32769 1 255\nabc", "P6 -1 1 255\nabc",
                           "P6 1x 1 255\nabc", "P6 99999999999999999999 1 255\nabc", "P6 1 1 65535\nabcdef",
                           "P6 1 1 15\nabc", "P3 1 1 255\n1 2 3 ", "P61 1 255\nabc", "", "#", "P6 #"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(decode_ppm(pictures::bytes(text), "bad.ppm"), Error);
  }
  CHECK_THROWS_AS(decode_png(pictures::png(0, 1, 8, 0, "\0a"s), "bad.png"), Error);
  CHECK_THROWS_AS(decode_png(pictures::png(32769, 1, 8, 0, "\0a"s), "bad.png"), Error);
  CHECK_THROWS_AS(decode_png(pictures::png(1, 1, 8, 5, "\0a"s), "bad.png"), Error);
  CHECK_THROWS_AS(decode_png(pictures::png(1, 1, 7, 0, "\0a"s), "bad.png"), Error);
  CHECK_THROWS_WITH_AS(decode_png(pictures::bytes("GIF89a and so on"), "bad.png"),
                       doctest::Contains("it does not begin as one"), Error);
}
