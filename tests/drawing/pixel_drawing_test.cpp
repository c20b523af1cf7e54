#include "drawing/pixel_drawing.hpp"

#include <doctest/doctest.h>

#include <velum/velum.hpp>

#include "drawing/short_number.hpp"

using namespace velum;

namespace {

constexpr Rgba8 sought{200, 0, 0, 255};
constexpr Rgba8 paper{255, 255, 255, 255};

RenderSettings small() {
  RenderSettings settings;
  settings.width = 20;
  settings.height = 20;
  return settings;
}

}  // namespace

TEST_CASE("the neighbourhood shows who is seen at each pixel, and the sought centre") {
  Scene scene;
  scene.add(shapes::house());
  const RenderSettings settings = small();
  const Camera camera = frame(scene.bounds(), projection::cabinet());
  const PixelExplanation pixel = explain_pixel(scene, camera, settings, 10, 12);
  REQUIRE_FALSE(pixel.fragments.empty());
  const Image<Rgba8> picture = draw_pixel(pixel, scene, camera, settings, {1, 32});
  // Margins of 56 to the left and 64 above; the middle cell is the second.
  CHECK(picture.width() > 56 + 3 * 32 + 24);  // the legend is wider than three cells
  CHECK(picture.at(56 + 48, 64 + 48) == sought);
  CHECK_FALSE(picture.at(56 + 32 + 3, 64 + 32 + 3) == paper);
}

TEST_CASE("at a corner of the picture, and on the background, too") {
  Scene scene;
  scene.add(shapes::house());
  const RenderSettings settings = small();
  const Camera camera = frame(scene.bounds(), projection::cabinet());
  const PixelExplanation pixel = explain_pixel(scene, camera, settings, 0, 0);
  const Image<Rgba8> picture = draw_pixel(pixel, scene, camera, settings, {2, 16});
  CHECK(picture.at(56 + 2 * 16 + 3, 64 + 2 * 16 + 3) == paper);  // its own cell: background
  CHECK_FALSE(picture.at(56 + 3, 64 + 3) == paper);              // outside of the picture: grey
}

TEST_CASE("short numbers are the same in every locale") {
  CHECK(short_number(0.412345678) == "0.4123");
  CHECK(short_number(-0.0) == "0");
  CHECK(short_number(1e-9, 2) == "1e-09");
}
