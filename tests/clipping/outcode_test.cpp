#include "clipping/outcode.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "clipping/clip_segment.hpp"

using velum::clip_point;
using velum::outcode;

// The lecture's bits: 5 above, 4 below, 3 right, 2 left, 1 behind, 0 in front.
static_assert(outcode({0, 0, 0.5, 1}) == 0b000000);
static_assert(outcode({0, 2, 0.5, 1}) == 0b100000);
static_assert(outcode({0, -2, 0.5, 1}) == 0b010000);
static_assert(outcode({2, 0, 0.5, 1}) == 0b001000);
static_assert(outcode({-2, 0, 0.5, 1}) == 0b000100);
static_assert(outcode({0, 0, 2, 1}) == 0b000010);
static_assert(outcode({0, 0, -1, 1}) == 0b000001);
static_assert(outcode({-2, 2, -1, 1}) == 0b100101);
static_assert(outcode({2, -2, 2, 1}) == 0b011010);

TEST_CASE("outcode: all 27 regions in the lecture's bit order") {
  // Column k: below the volume, inside, above it, on that axis.
  const double xs[3] = {-2.0, 0.25, 1.5};
  const double zs[3] = {-0.5, 0.75, 1.5};
  const int x_bits[3] = {0b000100, 0, 0b001000};
  const int y_bits[3] = {0b010000, 0, 0b100000};
  const int z_bits[3] = {0b000001, 0, 0b000010};
  for (const double w : {1.0, 3.0, 0x1p-30}) {
    for (int i = 0; i < 27; ++i) {
      const int x = i % 3, y = i / 3 % 3, z = i / 9;
      CAPTURE(i);
      CHECK(int{outcode(glm::dvec4(xs[x] * w, xs[y] * w, zs[z] * w, w))} ==
            (x_bits[x] | y_bits[y] | z_bits[z]));
    }
  }
}

TEST_CASE("outcode: a point on a plane is inside it, one ulp beyond is not") {
  const double beyond = std::nextafter(1.0, 2.0);
  for (const double x : {-1.0, 1.0}) {
    CHECK(outcode({x, x, 0.0, 1.0}) == 0);
    CHECK(outcode({x, x, 1.0, 1.0}) == 0);
  }
  CHECK(outcode({beyond, 0, 0.5, 1}) == 0b001000);
  CHECK(outcode({-beyond, 0, 0.5, 1}) == 0b000100);
  CHECK(outcode({0, beyond, 0.5, 1}) == 0b100000);
  CHECK(outcode({0, -beyond, 0.5, 1}) == 0b010000);
  CHECK(outcode({0, 0, beyond, 1}) == 0b000010);
  CHECK(outcode({0, 0, -std::numeric_limits<double>::denorm_min(), 1}) == 0b000001);
  CHECK(outcode({0, 0, -0.0, 1}) == 0);
}

TEST_CASE("outcode: behind the eye (w < 0) a point is outside one plane of every pair, or both") {
  CHECK(outcode({0, 0, -0.5, -1}) == 0b111111);
  CHECK(outcode({0, 0, 0.5, -1}) == 0b111110);
  CHECK(outcode({0, 0, -2, -1}) == 0b111101);
  CHECK(outcode({5, 0, -0.5, -1}) == 0b111011);
  CHECK(outcode({1, 0, 0, 0}) == 0b001000);  // at infinity
}

TEST_CASE("outcode: NaN is outside, and the zero vector is no point") {
  const double nan = std::nan("");
  for (int axis = 0; axis < 4; ++axis) {
    glm::dvec4 p{0, 0, 0.5, 1};
    p[axis] = nan;
    CHECK(outcode(p) != 0);
    CHECK_FALSE(clip_point(p));
  }
  CHECK(outcode({nan, nan, nan, nan}) == 0b111111);
  CHECK_FALSE(clip_point({0, 0, 0, 0}));
  CHECK(clip_point({1, -1, 0, 1}));
  CHECK_FALSE(clip_point({1.5, -1, 0, 1}));
}

TEST_CASE("clip planes: the table's rows are named and ordered as the enumeration") {
  using velum::ClipPlane;
  const auto name = [](ClipPlane plane) {
    return std::string(velum::clip_planes[static_cast<unsigned>(plane)].name);
  };
  CHECK(name(ClipPlane::front) == "in front");
  CHECK(name(ClipPlane::behind) == "behind");
  CHECK(name(ClipPlane::left) == "left");
  CHECK(name(ClipPlane::right) == "right");
  CHECK(name(ClipPlane::below) == "below");
  CHECK(name(ClipPlane::above) == "above");
}
