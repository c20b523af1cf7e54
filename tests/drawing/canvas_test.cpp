#include "drawing/canvas.hpp"

#include <doctest/doctest.h>

#include <array>
#include <limits>

using namespace velum;

namespace {

constexpr Rgba8 white{255, 255, 255, 255};
constexpr Rgba8 black{0, 0, 0, 255};
constexpr Rgba8 clear{0, 0, 0, 0};

/// The share of ink on the whole canvas, in pixels: the sum of alphas.
double ink_on(const Canvas& canvas) {
  const Image<Rgba8> picture = canvas.picture();
  double sum = 0.0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) sum += picture.at(x, y).a / 255.0;
  }
  return sum;
}

}  // namespace

TEST_CASE("a line covers its length times its thickness, whichever way it runs") {
  for (const glm::dvec2& end : {glm::dvec2(90, 50), glm::dvec2(50, 90), glm::dvec2(78.28, 78.28)}) {
    Canvas canvas(100, 100, clear);
    canvas.line({50, 50}, end, 3.0, black);
    CHECK(ink_on(canvas) == doctest::Approx(40 * 3.0 + 3.14159 * 1.5 * 1.5).epsilon(0.03));
  }
}

TEST_CASE("a horizontal line through pixel centres fills exactly its row") {
  Canvas canvas(20, 9, white);
  canvas.line({2.5, 4.5}, {17.5, 4.5}, 1.0, black);
  const Image<Rgba8> picture = canvas.picture();
  CHECK(picture.at(10, 4) == black);
  CHECK(picture.at(10, 3) == white);
  CHECK(picture.at(10, 5) == white);
  CHECK(picture.at(19, 4) == white);
}

TEST_CASE("discs, rings and polygons have the area they should") {
  Canvas disc(50, 50, clear);
  disc.disc({25.3, 24.8}, 10.0, black);
  CHECK(ink_on(disc) == doctest::Approx(314.16).epsilon(0.01));
  Canvas ring(50, 50, clear);
  ring.ring({25, 25}, 10.0, 2.0, black);
  CHECK(ink_on(ring) == doctest::Approx(2 * 3.14159 * 10.0 * 2.0).epsilon(0.01));
  Canvas polygon(50, 50, clear);
  const std::array<glm::dvec2, 3> triangle{glm::dvec2(5, 5), glm::dvec2(45, 10), glm::dvec2(10, 40)};
  polygon.polygon(triangle, black);
  CHECK(ink_on(polygon) == doctest::Approx(0.5 * (40 * 35 - 5 * 5)).epsilon(0.01));
}

TEST_CASE("later ink lies over earlier ink, blended in linear light") {
  Canvas canvas(1, 1, black);
  canvas.rectangle(0, 0, 1, 1, {255, 255, 255, 128});
  const Rgba8 pixel = canvas.picture().at(0, 0);
  CHECK(pixel == srgb_from_linear(glm::vec4(128.0f / 255.0f, 128.0f / 255.0f, 128.0f / 255.0f, 1.0f)));
}

TEST_CASE("letters are 5x7 dots at the place that the anchor says") {
  CHECK(Canvas::text_width("", 2) == 0);
  CHECK(Canvas::text_width("ab", 2) == 22);
  Canvas canvas(30, 10, white);
  canvas.text({2, 1}, "L", 1, black);
  canvas.text({29, 1}, "L", 1, black, TextAnchor::right);
  const Image<Rgba8> picture = canvas.picture();
  for (const int left : {2, 24}) {
    CHECK(picture.at(left, 1) == black);      // the stem's top
    CHECK(picture.at(left, 7) == black);      // the corner
    CHECK(picture.at(left + 4, 7) == black);  // the foot's end
    CHECK(picture.at(left + 1, 1) == white);
    CHECK(picture.at(left, 8) == white);
  }
}

TEST_CASE("what lies outside or is not finite draws nothing and breaks nothing") {
  const double infinity = std::numeric_limits<double>::infinity();
  Canvas canvas(10, 10, clear);
  canvas.line({-1e300, -50}, {1e300, -40}, 1.0, black);
  canvas.line({0, 0}, {infinity, 5}, 1.0, black);
  canvas.disc({1e9, 1e9}, 5.0, black);
  canvas.dashed_line({-1e12, -9}, {1e12, -9}, 1.0, 3.0, black);
  canvas.text({-1e30, 1e30}, "far", 2, black);
  canvas.rectangle(-5, -5, 3, 3, black);
  CHECK(ink_on(canvas) == 0.0);
}
