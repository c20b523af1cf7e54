#include "image/texture.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "base/contract.hpp"
#include "pictures.hpp"

using namespace velum;

namespace {

/// In double, so that only the texture's own rounding shows.
glm::dvec4 mean_of(const Image<glm::vec4>& level) {
  glm::dvec4 sum(0.0);
  for (int y = 0; y < level.height(); ++y) {
    for (int x = 0; x < level.width(); ++x) sum += glm::dvec4(level.at(x, y));
  }
  return sum / (static_cast<double>(level.width()) * level.height());
}

void check_close(const glm::dvec4& a, const glm::dvec4& b, double tolerance) {
  for (int i = 0; i < 4; ++i) CHECK(std::abs(a[i] - b[i]) <= tolerance);
}

}  // namespace

TEST_CASE("texels are linear and premultiplied; row 0 is the top") {
  Image<Rgba8> picture(2, 2, Rgba8{255, 255, 255, 255});
  picture.at(1, 0) = {188, 55, 0, 128};
  picture.at(0, 1) = {255, 255, 255, 0};
  const Texture texture(picture);
  const float alpha = 128.0f / 255.0f;
  CHECK(texture.width() == 2);
  CHECK(texture.height() == 2);
  CHECK_FALSE(texture.is_opaque());
  CHECK(texture.level(0).at(0, 0) == glm::vec4(1.0f));
  CHECK(texture.level(0).at(1, 0) ==
        glm::vec4(linear_from_srgb(188) * alpha, linear_from_srgb(55) * alpha, 0.0f, alpha));
  CHECK(texture.level(0).at(0, 1) == glm::vec4(0.0f));
}

TEST_CASE("levels halve, rounding down, to one texel, and each keeps the mean of the picture") {
  const int sizes[][2] = {{1, 1}, {1, 7},  {9, 1},  {2, 2},   {3, 3},   {4, 8},
                          {5, 4}, {6, 11}, {7, 13}, {31, 17}, {64, 64}, {100, 37}};
  for (const auto& [width, height] : sizes) {
    CAPTURE(width);
    CAPTURE(height);
    const Texture texture(pictures::noise(width, height, false));
    const glm::dvec4 mean = mean_of(texture.level(0));
    for (int i = 1; i < texture.level_count(); ++i) {
      const Image<glm::vec4>& level = texture.level(i);
      CHECK(level.width() == std::max(1, texture.level(i - 1).width() / 2));
      CHECK(level.height() == std::max(1, texture.level(i - 1).height() / 2));
      check_close(mean_of(level), mean, 1e-7);
    }
    const Image<glm::vec4>& last = texture.level(texture.level_count() - 1);
    CHECK(last.width() == 1);
    CHECK(last.height() == 1);
  }
}

TEST_CASE("an odd size shares its texels by area: five become two") {
  Image<Rgba8> picture(5, 1);
  for (int x = 0; x < 5; ++x) picture.at(x, 0) = {0, 0, 0, static_cast<std::uint8_t>(x * 60)};
  const Texture texture(picture);
  // Each covers two and a half: (0 + 60 + ½·120)/2.5 and (½·120 + 180 + 240)/2.5.
  CHECK(double(texture.level(1).at(0, 0).a) == doctest::Approx(48.0 / 255.0).epsilon(1e-7));
  CHECK(double(texture.level(1).at(1, 0).a) == doctest::Approx(192.0 / 255.0).epsilon(1e-7));
}

TEST_CASE("what is transparent does not bleed into the levels") {
  Image<Rgba8> picture(2, 1);
  picture.at(0, 0) = {255, 0, 0, 255};
  picture.at(1, 0) = {0, 255, 0, 0};
  CHECK(Texture(picture).level(1).at(0, 0) == glm::vec4(0.5f, 0.0f, 0.0f, 0.5f));
}

TEST_CASE("a texture of a window on a picture, and its hash") {
  const Image<Rgba8> picture = pictures::noise(8, 8, true);
  const ImageView<const Rgba8> whole = picture.view();
  const Texture part(ImageView<const Rgba8>{whole.row(2) + 3, 4, 2, whole.stride});
  CHECK(part.width() == 4);
  CHECK(part.height() == 2);
  CHECK(part.is_opaque());
  CHECK(part.level(0).at(1, 1) == linear_from_srgb(picture.at(4, 3)));
  CHECK(Texture(picture).content_hash() == Texture(pictures::noise(8, 8, true)).content_hash());
  CHECK(Texture(picture).content_hash() != part.content_hash());
  CHECK(Texture(picture).content_hash() != Texture(pictures::noise(8, 8, true, 2)).content_hash());
  CHECK_THROWS_AS(Texture(ImageView<const Rgba8>{}), ContractViolation);
}
