#include <doctest/doctest.h>

#include <cmath>

#include "projection/facing.hpp"
#include "random.hpp"
#include "visibility/depth_plane.hpp"

using namespace velum;

namespace {

constexpr Viewport viewport{200, 100};

glm::dvec4 clip(double px, double py, double r, double w) {
  const glm::dvec2 ndc = viewport.ndc_from_pixel(px, py);
  return glm::dvec4(ndc.x, ndc.y, 1.0 - r, 1.0) * w;
}

DepthPlane plane_of(const std::array<glm::dvec4, 3>& v) {
  return depth_plane(v, homogeneous_determinant(v[0], v[1], v[2]), viewport);
}

}  // namespace

TEST_CASE("the depth plane passes through its vertices, whatever their w") {
  Random random{3};
  for (int i = 0; i < 2000; ++i) {
    const double r[3] = {random.uniform(), random.uniform(), random.uniform()};
    const int x[3] = {random.below(60), 70 + random.below(60), 140 + random.below(60)};
    const int y[3] = {random.below(40), 60 + random.below(40), random.below(40)};
    std::array<glm::dvec4, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = clip(x[k] + 0.5, y[k] + 0.5, r[k], random.uniform(0.1, 10.0));
    const DepthPlane plane = plane_of(v);
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::fabs(plane.at(x[k], y[k]) - r[k]) < 2e-6);
    CHECK(plane.lower <= plane.upper);
  }
}

TEST_CASE(
    "distant surfaces keep reversed depth's resolution: relative error at the far end of a long plane") {
  // A floor from r = 1 to r = 1e-5, w in proportion to 1/r as perspective has it.
  const std::array<glm::dvec4, 3> floor{clip(10.5, 99.5, 1.0, 1.0), clip(190.5, 99.5, 1.0, 1.0),
                                        clip(100.5, 0.5, 1e-5, 1e5)};
  const DepthPlane plane = plane_of(floor);
  CHECK(std::fabs(plane.at(100, 0) - 1e-5) < 1e-5 * 1e-6);
  CHECK(std::fabs(plane.at(100, 1) - (1e-5 + (1.0 - 1e-5) / 99.0)) < 1e-7);
}

TEST_CASE(
    "the depth plane of a tiny determinant, whose reciprocal is infinite, is as steep as it should be") {
  constexpr double w = 1e-104;
  const std::array<glm::dvec4, 3> v = {clip(10.5, 10.5, 0.25, w), clip(190.5, 20.5, 0.5, w),
                                       clip(30.5, 90.5, 0.75, w)};
  REQUIRE(std::isinf(1.0 / homogeneous_determinant(v[0], v[1], v[2])));
  const DepthPlane plane = plane_of(v);
  CHECK(std::fabs(plane.at(10, 10) - 0.25) < 2e-6);
  CHECK(std::fabs(plane.at(190, 20) - 0.5) < 2e-6);
  CHECK(std::fabs(plane.at(30, 90) - 0.75) < 2e-6);
}

TEST_CASE("a triangle seen exactly edge-on has the depth of its nearest vertex") {
  const std::array<glm::dvec4, 3> wall{clip(50.5, 10.5, 0.2, 1.0), clip(50.5, 90.5, 0.7, 1.0),
                                       clip(50.5, 50.5, 0.4, 1.0)};
  REQUIRE(homogeneous_determinant(wall[0], wall[1], wall[2]) == 0.0);
  const DepthPlane plane = plane_of(wall);
  CHECK(plane.at(50, 10) == doctest::Approx(0.7f));
  CHECK(plane.at(0, 0) == plane.at(199, 99));
}

TEST_CASE("the depth never leaves the vertices' range, is never NaN and never negative") {
  Random random{4};
  for (int i = 0; i < 5000; ++i) {
    std::array<glm::dvec4, 3> v;
    const double needle = i % 2 == 0 ? 1e-9 : 1.0;
    const double x = random.uniform(0, 200), y = random.uniform(0, 100);
    for (glm::dvec4& vertex : v) {
      const double w = i % 3 == 0 ? random.uniform(-1.0, 1.0) : random.uniform(0.1, 2.0);
      vertex = clip(x + needle * random.uniform(-50, 50), y + needle * random.uniform(-50, 50),
                    random.uniform(-0.5, 1.5), w);
    }
    if (!(v[0].w > 0.0 || v[1].w > 0.0 || v[2].w > 0.0)) continue;
    const DepthPlane plane = plane_of(v);
    for (int k = 0; k < 20; ++k) {
      const float r = plane.at(random.below(200), random.below(100));
      CHECK(r >= plane.lower);
      CHECK(r <= plane.upper);
      CHECK(!std::signbit(r));
      CHECK(r <= 1.0f);
    }
  }
}

TEST_CASE("the depth is monotone in x and in y, bit for bit") {
  Random random{5};
  for (int i = 0; i < 300; ++i) {
    std::array<glm::dvec4, 3> v;
    for (glm::dvec4& vertex : v)
      vertex =
          clip(random.uniform(0, 200), random.uniform(0, 100), random.uniform(), random.uniform(0.1, 2.0));
    const DepthPlane plane = plane_of(v);
    const int y = random.below(100);
    for (int x = 1; x < 200; ++x) {
      if (plane.dx >= 0.0f) CHECK(plane.at(x, y) >= plane.at(x - 1, y));
      if (plane.dx <= 0.0f) CHECK(plane.at(x, y) <= plane.at(x - 1, y));
    }
  }
}

TEST_CASE("on the far plane the depth is +0, so that depth bits compare as integers") {
  Random random{5};
  for (int i = 0; i < 2000; ++i) {
    std::array<glm::dvec4, 3> v;
    for (glm::dvec4& vertex : v) vertex = clip(random.uniform(0, 200), random.uniform(0, 100), 0.0, 1.0);
    const DepthPlane plane = plane_of(v);
    for (int k = 0; k < 4; ++k) {
      const float r = plane.at(random.below(200), random.below(100));
      CHECK(r == 0.0f);
      CHECK(!std::signbit(r));
    }
  }
}
