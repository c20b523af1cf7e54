#include "image/compare.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"

using namespace velum;

TEST_CASE("equal pictures do not differ, whatever their strides") {
  const Image<Rgba8> a(5, 3, Rgba8{1, 2, 3, 4});
  const Image<Rgba8> larger(50, 9, Rgba8{1, 2, 3, 4});
  const ImageDifference d = compare(a, ImageView<const Rgba8>{larger.row(2) + 7, 5, 3, larger.stride()});
  CHECK(d.same_bytes);
  CHECK(d.max == 0.0);
  CHECK(d.mean == 0.0);
  CHECK(d.rmse == 0.0);
  CHECK(d.pixels_over == 0);
  CHECK(std::isinf(d.psnr));
}

TEST_CASE("differences are measured per channel") {
  const Image<Rgba8> a(4, 2, Rgba8{10, 20, 30, 255});
  Image<Rgba8> b = a;
  b.at(3, 0).r = 13;
  b.at(1, 1).b = 0;
  b.at(2, 1).a = 225;
  const ImageDifference d = compare(a, b, 3.0);
  CHECK_FALSE(d.same_bytes);
  CHECK(d.max == 30.0);
  CHECK(d.worst_x == 1);
  CHECK(d.worst_y == 1);
  CHECK(d.pixels_over == 2);
  CHECK(compare(a, b).pixels_over == 3);
  CHECK(d.mean == doctest::Approx(63.0 / 32.0));
  CHECK(d.rmse == doctest::Approx(std::sqrt(1809.0 / 32.0)));
  CHECK(d.psnr == doctest::Approx(20.0 * std::log10(255.0 / std::sqrt(1809.0 / 32.0))));
}

TEST_CASE("floats: infinities and NaN have their places") {
  constexpr float inf = std::numeric_limits<float>::infinity();
  constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
  Image<float> a(2, 2, inf);
  Image<float> b = a;
  a.at(0, 0) = b.at(0, 0) = nan_value;
  CHECK(compare(a, b).same_bytes);
  CHECK(compare(a, b).max == 0.0);
  a.at(1, 0) = 0.0f;
  b.at(1, 0) = -0.0f;
  CHECK_FALSE(compare(a, b).same_bytes);
  CHECK(compare(a, b).max == 0.0);
  b.at(1, 1) = 5.0f;
  CHECK(compare(a, b).max == inf);
  CHECK(compare(a, b).worst_y == 1);
  b.at(1, 1) = nan_value;
  CHECK(compare(a, b).max == inf);
  CHECK(compare(a, b, 1e300).pixels_over == 1);
}

TEST_CASE("three channels") {
  const Image<glm::vec3> a(2, 1, glm::vec3(0.0f));
  Image<glm::vec3> b = a;
  b.at(1, 0) = {0.0f, -0.5f, 0.25f};
  const ImageDifference d = compare(a, b, 0.0, 2.0);
  CHECK(d.max == 0.5);
  CHECK(d.mean == doctest::Approx(0.125));
  CHECK(d.pixels_over == 1);
  CHECK(d.psnr == doctest::Approx(20.0 * std::log10(2.0 / std::sqrt(0.3125 / 6.0))));
}

TEST_CASE("pictures of different sizes cannot be compared") {
  CHECK_THROWS_WITH_AS(compare(Image<float>(2, 3), Image<float>(3, 2)),
                       doctest::Contains("differ in size: 2x3 and 3x2"), Error);
}
