#include "drawing/clip_drawing.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace velum;

namespace {

int pixels_of_colour(const Image<Rgba8>& picture, const Rgba8& colour) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) count += picture.at(x, y) == colour;
  }
  return count;
}

constexpr Rgba8 made{200, 0, 0, 255};

}  // namespace

TEST_CASE("one panel for the triangle and one for each plane that cuts") {
  const ClipTrace inside = trace_clipping({0, 0, 0.5, 1}, {0.5, 0, 0.5, 1}, {0, 1, 0.5, 1});
  CHECK(draw_clipping(inside, 200).width() == 200);
  const ClipTrace right = trace_clipping({0, 0, 0.5, 1}, {2, 0, 0.5, 1}, {0, 0.8, 0.5, 1});
  const Image<Rgba8> two = draw_clipping(right, 200);
  CHECK(two.width() == 400);
  CHECK(two.height() == 200);
  // Two new vertices: filled dots of radius 4, and their numbers.
  CHECK(pixels_of_colour(two, made) > 60);
  CHECK(pixels_of_colour(draw_clipping(inside, 200), made) == 0);
  const ClipTrace all = trace_clipping({-5, -4, 0.4, 1}, {6, -3, 1.8, 1}, {0, 9, -0.7, 1});
  CHECK(draw_clipping(all, 150).width() == 450);
  CHECK(draw_clipping(all, 150).height() == 450);
}

TEST_CASE("triangles behind the eye, rejected or not finite are drawn as far as they can be") {
  const ClipTrace behind = trace_clipping({0, 0, 0.5, 1}, {0.5, 0, 0.5, 1}, {0, 1, -2, -1});
  CHECK(draw_clipping(behind, 200).width() == 400);
  const ClipTrace all_behind = trace_clipping({0, 0, -2, -1}, {1, 0, -2, -1}, {0, 1, -2, -1});
  CHECK(draw_clipping(all_behind, 200).width() == 200);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(draw_clipping(trace_clipping({nan, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}), 200).width() == 200);
}
