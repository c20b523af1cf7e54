#include "image/colour.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "random.hpp"

namespace {

/// The decoding curve of IEC 61966-2-1 in extended precision: the oracle.
long double curve(long double encoded) {
  return encoded <= 0.04045L ? encoded / 12.92L : std::pow((encoded + 0.055L) / 1.055L, 2.4L);
}

std::uint8_t nearest_code(float linear) {
  int code = 0;
  while (code < 255 &&
         static_cast<long double>(linear) >= curve((static_cast<long double>(code) + 0.5L) / 255))
    ++code;
  return static_cast<std::uint8_t>(code);
}

}  // namespace

TEST_CASE("every sRGB code survives decoding and encoding") {
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    CHECK(velum::srgb_from_linear(velum::linear_from_srgb(code)) == code);
    CHECK(velum::linear_from_srgb(code) == static_cast<float>(curve(i / 255.0L)));
    if (i > 0)
      CHECK(velum::linear_from_srgb(code) > velum::linear_from_srgb(static_cast<std::uint8_t>(i - 1)));
  }
  CHECK(velum::linear_from_srgb(std::uint8_t{0}) == 0.0f);
  CHECK(velum::linear_from_srgb(std::uint8_t{255}) == 1.0f);
}

TEST_CASE("encoding rounds half up: the code changes exactly at the boundary") {
  for (int code = 0; code < 255; ++code) {
    // The first float on or above the boundary gets the upper code, the float before it the lower one.
    const long double boundary = curve((code + 0.5L) / 255);
    float first_above = static_cast<float>(boundary);
    if (static_cast<long double>(first_above) < boundary) first_above = std::nextafter(first_above, 2.0f);
    CAPTURE(code);
    CHECK(velum::srgb_from_linear(first_above) == code + 1);
    CHECK(velum::srgb_from_linear(std::nextafter(first_above, 0.0f)) == code);
  }
}

TEST_CASE("encoding is monotone and agrees with the curve") {
  std::uint8_t last = 0;
  for (int i = 0; i <= 100000; ++i) {
    const std::uint8_t code = velum::srgb_from_linear(static_cast<float>(i) / 100000.0f);
    REQUIRE(code >= last);
    last = code;
  }
  CHECK(last == 255);
  Random random{1};
  for (int i = 0; i < 5000; ++i) {
    const auto linear = static_cast<float>(random.uniform() * random.uniform());
    REQUIRE(velum::srgb_from_linear(linear) == nearest_code(linear));
  }
}

TEST_CASE("what is no colour becomes black or white") {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float value : {-1.0f, -0.0f, 0.0f, -infinity, std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::denorm_min()}) {
    CHECK(velum::srgb_from_linear(value) == 0);
  }
  for (const float value : {1.0f, 1.5f, infinity}) CHECK(velum::srgb_from_linear(value) == 255);
  CHECK(velum::srgb_from_linear(std::nextafter(1.0f, 0.0f)) == 255);
}

TEST_CASE("alpha is linear and straight, half up") {
  for (int i = 0; i < 256; ++i) {
    const velum::Rgba8 colour{10, 200, 30, static_cast<std::uint8_t>(i)};
    CHECK(velum::srgb_from_linear(velum::linear_from_srgb(colour)) == colour);
  }
  CHECK(velum::srgb_from_linear(glm::vec4(0, 0, 0, 0.5f)).a == 128);
  CHECK(velum::srgb_from_linear(glm::vec4(0, 0, 0, std::nextafter(0.5f, 0.0f))).a == 127);
  CHECK(velum::srgb_from_linear(glm::vec4(0, 0, 0, std::numeric_limits<float>::quiet_NaN())).a == 0);
}
