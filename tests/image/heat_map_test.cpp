#include "image/heat_map.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "base/error.hpp"

using namespace velum;

namespace {

int brightness(const Rgba8& colour) {
  return colour.r + colour.g + colour.b;
}

}  // namespace

TEST_CASE("where colours are equal the heat map shows the first picture, dim") {
  Image<Rgba8> a(3, 2, Rgba8{255, 255, 255, 255});
  a.at(1, 0) = {0, 0, 0, 255};
  a.at(2, 1) = {255, 255, 255, 0};
  const Image<Rgba8> map = heat_map(a, a);
  CHECK(map.at(0, 0) == Rgba8{85, 85, 85, 255});
  CHECK(map.at(1, 0) == Rgba8{0, 0, 0, 255});
  CHECK(map.at(2, 1) == Rgba8{0, 0, 0, 255});
}

TEST_CASE("the heat map is the lighter the larger the difference, and one code already shows") {
  const Image<Rgba8> a(256, 1, Rgba8{0, 0, 0, 255});
  Image<Rgba8> b = a;
  for (int x = 0; x < 256; ++x) b.at(x, 0).g = static_cast<std::uint8_t>(x);
  const Image<Rgba8> map = heat_map(a, b);
  CHECK(map.at(1, 0).r > 150);
  for (int x = 1; x < 256; ++x) CHECK(brightness(map.at(x, 0)) >= brightness(map.at(x - 1, 0)));
  CHECK(map.at(255, 0) == Rgba8{255, 255, 255, 255});
  CHECK(brightness(map.at(128, 0)) < brightness(map.at(255, 0)));
}

TEST_CASE("alpha counts in the heat map") {
  const Image<Rgba8> a(1, 1, Rgba8{9, 9, 9, 255});
  const Image<Rgba8> b(1, 1, Rgba8{9, 9, 9, 0});
  CHECK(heat_map(a, b).at(0, 0) == Rgba8{255, 255, 255, 255});
}

TEST_CASE("of floats, the largest finite difference and any that is not finite are white") {
  Image<float> a(4, 1, 1.0f);
  Image<float> b = a;
  b.at(1, 0) = 1.001f;
  b.at(2, 0) = 1.004f;
  b.at(3, 0) = std::numeric_limits<float>::infinity();
  const Image<Rgba8> map = heat_map(a, b);
  CHECK(map.at(0, 0) == Rgba8{0, 0, 0, 255});
  CHECK(map.at(1, 0).r > 100);
  CHECK(brightness(map.at(1, 0)) < brightness(map.at(2, 0)));
  CHECK(map.at(2, 0) == Rgba8{255, 255, 255, 255});
  CHECK(map.at(3, 0) == Rgba8{255, 255, 255, 255});
}

TEST_CASE("of vectors the channel that differs most counts") {
  const Image<glm::vec3> a(2, 1, glm::vec3(0.0f));
  Image<glm::vec3> b = a;
  b.at(1, 0).z = -2.0f;
  const Image<Rgba8> map = heat_map(a, b);
  CHECK(map.at(0, 0) == Rgba8{0, 0, 0, 255});
  CHECK(map.at(1, 0) == Rgba8{255, 255, 255, 255});
}

TEST_CASE("a heat map needs two pictures of one size") {
  CHECK_THROWS_AS(heat_map(Image<float>(2, 2), Image<float>(2, 3)), Error);
  CHECK_THROWS_AS(heat_map(Image<Rgba8>(3, 2), Image<Rgba8>(2, 2)), Error);
}
