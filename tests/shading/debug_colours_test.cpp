#include "shading/debug_colours.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include "image/colour.hpp"
#include "image/visibility_buffer.hpp"
#include "shading/shading.hpp"
#include "shading/wireframe.hpp"

namespace {

velum::Rgba8 code_of(std::uint32_t id) {
  return velum::srgb_from_linear(velum::id_colour(id));
}

int distance(const velum::Rgba8& a, const velum::Rgba8& b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace

TEST_CASE("the first ten thousand ids have distinct colours, and neighbours differ strongly") {
  std::set<std::tuple<int, int, int>> seen;
  int nearest_neighbours = 255;
  int darkest = 255;
  for (std::uint32_t id = 0; id < 10000; ++id) {
    const velum::Rgba8 c = code_of(id);
    CHECK(c.a == 255);
    seen.insert({c.r, c.g, c.b});
    nearest_neighbours = std::min(nearest_neighbours, distance(c, code_of(id + 1)));
    darkest = std::min(darkest, int(std::max({c.r, c.g, c.b})));
  }
  CHECK(seen.size() == 10000);
  CHECK(nearest_neighbours >= 100);
  CHECK(darkest >= 127);
}

TEST_CASE("the first hundred id colours are far apart pairwise") {
  int nearest = 255;
  for (std::uint32_t i = 0; i < 100; ++i)
    for (std::uint32_t j = 0; j < i; ++j) nearest = std::min(nearest, distance(code_of(i), code_of(j)));
  CHECK(nearest >= 16);
}

TEST_CASE("id colours never change") {
  CHECK(code_of(velum::no_primitive) == velum::Rgba8{0, 0, 0, 255});
  CHECK(code_of(0) == velum::Rgba8{255, 0, 0, 255});
  CHECK(code_of(1) == velum::Rgba8{86, 120, 202, 255});
  CHECK(code_of(2) == velum::Rgba8{105, 149, 43, 255});
  CHECK(code_of(12345) == velum::Rgba8{106, 126, 196, 255});
  CHECK(code_of(0xFFFFFFFEu) == velum::Rgba8{163, 64, 233, 255});
}

TEST_CASE("debug views come out as the sRGB codes they mean") {
  for (int code = 0; code <= 255; ++code) {
    const glm::vec4 colour = velum::colour_of_codes(glm::vec3(float(code) / 255.0f));
    const auto c = static_cast<std::uint8_t>(code);
    CHECK(velum::srgb_from_linear(colour) == velum::Rgba8{c, c, c, 255});
  }
  CHECK(velum::srgb_from_linear(velum::colour_of_codes({-1.0f, 2.0f, std::nanf("")})) ==
        velum::Rgba8{0, 255, 0, 255});
  CHECK(velum::srgb_from_linear(velum::normal_colour({0, 0, 1})) == velum::Rgba8{128, 128, 255, 255});
  CHECK(velum::srgb_from_linear(velum::normal_colour({-1, 0, 0})) == velum::Rgba8{0, 128, 128, 255});
}

TEST_CASE("the depth view goes from near white to far dark grey") {
  const velum::MetricRange range{2.0, 6.0};
  CHECK(velum::srgb_from_linear(velum::depth_colour(2.0, range)).r == 255);
  CHECK(velum::srgb_from_linear(velum::depth_colour(4.0, range)).r == 140);  // 0.55 · 255 = 140.25
  CHECK(velum::srgb_from_linear(velum::depth_colour(6.0, range)).r == 26);   // 0.1 · 255 = 25.5, half up
  CHECK(velum::srgb_from_linear(velum::depth_colour(3.0, {3.0, 3.0})).r == 255);
}

TEST_CASE("the wireframe has one ink, which stands out from the background and every material") {
  const glm::vec4 black(0, 0, 0, 1), white(1, 1, 1, 1);
  const velum::Rgba8 clear{0, 0, 0, 0}, dark{8, 8, 8, 255}, light{250, 250, 250, 255};
  velum::Material material;
  const auto with = [&](float grey) {
    material.base_colour = glm::vec3(grey);
    velum::Scene result;
    result.add_material(material);
    return result;
  };
  CHECK(velum::wireframe_ink(with(0.8f), clear) == black);
  CHECK(velum::wireframe_ink(with(0.8f), light) == black);
  CHECK(velum::wireframe_ink(with(0.01f), clear) == white);
  CHECK(velum::wireframe_ink(with(0.01f), dark) == white);
  const glm::vec4 red = velum::wireframe_ink(with(0.8f), dark);
  CHECK(red != black);
  CHECK(red != white);
  CHECK(velum::wireframe_ink(with(0.01f), light) == red);
  // A board of black and white squares, each larger than the parts that are looked at.
  velum::Image<velum::Rgba8> board(64, 64, velum::Rgba8{255, 255, 255, 255});
  for (int y = 0; y < 32; ++y) std::fill_n(board.row(y), 32, velum::Rgba8{0, 0, 0, 255});
  material.texture = std::make_shared<const velum::Texture>(board);
  CHECK(velum::wireframe_ink(with(1.0f), clear) == red);
}
