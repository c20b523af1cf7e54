#include <doctest/doctest.h>

#include <bit>
#include <cstring>
#include <limits>

#include "base/error.hpp"
#include "image/compare.hpp"
#include "pictures.hpp"

using namespace velum;
using pictures::Bytes;
using pictures::noise;

namespace {

bool same(ImageView<const Rgba8> a, ImageView<const Rgba8> b) {
  return a.width == b.width && a.height == b.height && compare(a, b).same_bytes;
}

/// A window of a larger picture, so that rows are far apart and do not begin aligned.
template <typename T>
ImageView<const T> window(const Image<T>& image, int x, int y, int width, int height) {
  return {image.row(y) + x, width, height, image.stride()};
}

Image<float> unusual_floats(int width, int height) {
  Random random{5};
  Image<float> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = static_cast<float>(random.uniform(-10, 10));
  }
  image.at(0, 0) = std::numeric_limits<float>::infinity();
  image.at(1, 0) = -0.0f;
  image.at(2, 0) = std::numeric_limits<float>::quiet_NaN();
  image.at(0, 1) = std::numeric_limits<float>::denorm_min();
  return image;
}

Image<glm::vec3> unusual_vectors(int width, int height) {
  const Image<float> floats = unusual_floats(width, height);
  Image<glm::vec3> image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = {floats.at(x, y), 1.0f, -floats.at(x, y)};
  }
  return image;
}

std::uint32_t bits(float value) {
  return std::bit_cast<std::uint32_t>(value);
}

}  // namespace

TEST_CASE("PNG: what was written is read back, opaque or not, any size, any stride") {
  for (const bool opaque : {true, false}) {
    for (const int size : {1, 2, 3, 16, 33}) {
      const Image<Rgba8> image = noise(size, 2 * size + 1, opaque);
      CHECK(same(image, decode_png(encode_png(image), "memory")));
    }
    const Image<Rgba8> large = noise(40, 30, opaque);
    CHECK(same(window(large, 5, 7, 11, 9), decode_png(encode_png(window(large, 5, 7, 11, 9)), "memory")));
  }
}

TEST_CASE("PNG: opaque pictures are RGB, others RGBA; both are marked as sRGB") {
  const Bytes rgb = encode_png(noise(4, 4, true));
  const Bytes rgba = encode_png(noise(4, 4, false));
  CHECK(std::to_integer<int>(rgb[25]) == 2);
  CHECK(std::to_integer<int>(rgba[25]) == 6);
  CHECK(pictures::text(rgb).find("sRGB") == 37);
  CHECK(pictures::text(rgb).substr(33, 13) == pictures::chunk("sRGB", std::string(1, '\0')));
}

TEST_CASE("PNG: grey, palette and 16-bit pictures become RGBA8") {
  using namespace std::string_literals;
  const Image<Rgba8> grey = decode_png(pictures::png(2, 1, 8, 0, "\0\x20\xf0"s), "grey");
  CHECK(grey.at(0, 0) == Rgba8{0x20, 0x20, 0x20, 255});
  CHECK(grey.at(1, 0) == Rgba8{0xf0, 0xf0, 0xf0, 255});

  const std::string palette =
      pictures::chunk("PLTE", "\x01\x02\x03\x0a\x0b\x0c"s) + pictures::chunk("tRNS", "\xff\x80"s);
  const Image<Rgba8> indexed = decode_png(pictures::png(2, 1, 1, 3, "\0\x40"s, palette), "palette");
  CHECK(indexed.at(0, 0) == Rgba8{1, 2, 3, 255});
  CHECK(indexed.at(1, 0) == Rgba8{10, 11, 12, 128});

  const Image<Rgba8> deep =
      decode_png(pictures::png(1, 1, 16, 6, "\0\x12\x34\x56\x78\x9a\xbc\xde\xf0"s), "deep");
  CHECK(deep.at(0, 0) == Rgba8{0x12, 0x56, 0x9a, 0xde});

  const Image<Rgba8> grey_alpha = decode_png(pictures::png(1, 1, 8, 4, "\0\x11\x22"s), "grey and alpha");
  CHECK(grey_alpha.at(0, 0) == Rgba8{0x11, 0x11, 0x11, 0x22});
}

TEST_CASE("PPM: what was written is read back without alpha; comments are skipped") {
  const Image<Rgba8> image = noise(13, 7, true);
  CHECK(same(image, decode_ppm(encode_ppm(image), "memory")));
  CHECK(same(window(image, 3, 2, 5, 4), decode_ppm(encode_ppm(window(image, 3, 2, 5, 4)), "memory")));
  CHECK(decode_ppm(encode_ppm(noise(3, 3, false)), "memory").at(1, 1).a == 255);
  CHECK(pictures::text(encode_ppm(noise(2, 1, true))).substr(0, 11) == "P6\n2 1\n255\n");

  const Image<Rgba8> commented =
      decode_ppm(pictures::bytes("P6 # a comment\n#another 9 9\n 2\t#\n1 # x\n255\nabcdef"), "memory");
  CHECK(commented.width() == 2);
  CHECK(commented.at(1, 0) == Rgba8{'d', 'e', 'f', 255});
}

TEST_CASE("PFM: one and three channels keep every bit, bottom row first in the file") {
  const Image<float> image = unusual_floats(5, 4);
  const Bytes file = encode_pfm(window(image, 0, 0, 3, 4));
  CHECK(pictures::text(file).substr(0, 12) == "Pf\n3 4\n-1.0\n");
  float first = 0.0f;
  std::memcpy(&first, &file[12], 4);  // little-endian machine, as all that tests run on
  CHECK(first == image.at(0, 3));
  const Image<float> back = decode_pfm(file, "memory");
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 3; ++x) CHECK(bits(back.at(x, y)) == bits(image.at(x, y)));
  }

  const Image<glm::vec3> vectors = unusual_vectors(5, 4);
  const Image<glm::vec3> vectors_back = decode_pfm_rgb(encode_pfm(vectors), "memory");
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      for (int i = 0; i < 3; ++i) CHECK(bits(vectors_back.at(x, y)[i]) == bits(vectors.at(x, y)[i]));
    }
  }
}

TEST_CASE("PFM: a positive scale means big-endian") {
  using namespace std::string_literals;
  const Image<float> image = decode_pfm(pictures::bytes("Pf\n1 2\n2.5\n\x3f\x80\0\0\xc0\0\0\0"s), "memory");
  CHECK(image.at(0, 1) == 1.0f);
  CHECK(image.at(0, 0) == -2.0f);
  CHECK_THROWS_AS(decode_pfm(pictures::bytes("Pf\n1 1\n0\nabcd"), "memory"), Error);
  CHECK_THROWS_AS(decode_pfm(pictures::bytes("Pf\n1 1\n-nan\nabcd"), "memory"), Error);
  CHECK_THROWS_AS(decode_pfm(pictures::bytes("PF\n1 1\n-1\nabcdabcdabcd"), "memory"), Error);
  CHECK_THROWS_AS(decode_pfm_rgb(pictures::bytes("Pf\n1 1\n-1\nabcd"), "memory"), Error);
}

TEST_CASE("NPY: header, padding and data are as NumPy defines them") {
  Image<std::uint32_t> ids(5, 3, 7u);
  ids.at(4, 2) = 0xFFFFFFFFu;
  const Bytes file = encode_npy(window(ids, 1, 0, 4, 3));
  const std::string text = pictures::text(file);
  CHECK(text.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length = static_cast<unsigned char>(text[8]) + 256u * static_cast<unsigned char>(text[9]);
  CHECK((10 + length) % 64 == 0);
  CHECK(text[9 + length] == '\n');
  CHECK(text.find("{'descr': '<u4', 'fortran_order': False, 'shape': (3, 4), }") == 10);
  CHECK(file.size() == 10 + length + 4 * 3 * 4);
  CHECK(text.substr(10 + length, 4) == std::string("\x07\0\0\0", 4));
  CHECK(text.substr(text.size() - 4) == "\xff\xff\xff\xff");

  CHECK(pictures::text(encode_npy(Image<float>(2, 3)))
            .find("'<f4', 'fortran_order': False, 'shape': (3, 2), }") != std::string::npos);
  CHECK(pictures::text(encode_npy(Image<glm::vec3>(2, 3))).find("'shape': (3, 2, 3), }") !=
        std::string::npos);
  const std::string colours = pictures::text(encode_npy(Image<Rgba8>(2, 1, Rgba8{1, 2, 3, 4})));
  CHECK(colours.find("'|u1', 'fortran_order': False, 'shape': (1, 2, 4), }") != std::string::npos);
  CHECK(colours.substr(colours.size() - 8) == "\x01\x02\x03\x04\x01\x02\x03\x04");
}

TEST_CASE("an empty picture cannot be written") {
  CHECK_THROWS_AS(encode_png({}), ContractViolation);
  CHECK_THROWS_AS(encode_ppm({}), ContractViolation);
  CHECK_THROWS_AS(encode_pfm(ImageView<const float>{}), ContractViolation);
  CHECK_THROWS_AS(encode_npy(Image<float>(0, 3)), ContractViolation);
}
