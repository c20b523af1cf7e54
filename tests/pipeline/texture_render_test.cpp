#include <doctest/doctest.h>

#include <memory>

#include "image/compare.hpp"
#include "pipeline/render.hpp"
#include "scene/builtin.hpp"
#include "scene/load_scene.hpp"

using namespace velum;

namespace {

/// Just above the middle of a side of the checkerboard, looking along it.
Camera over_the_board() {
  return Camera::perspective(Pose::towards({0.3, 1.5, 127.0}, {0.3, 1.2, 125.0}), {}, 0.1, 400.0);
}

RenderSettings settings_with(TextureFilter filter) {
  RenderSettings settings;
  settings.width = 96;
  settings.height = 54;
  settings.texture_filter = filter;
  return settings;
}

bool is_equal(const Image<Rgba8>& a, const Image<Rgba8>& b, int left = 0, int top = 0) {
  for (int y = 0; y < b.height(); ++y) {
    for (int x = 0; x < b.width(); ++x) {
      if (a.at(x + left, y + top) != b.at(x, y)) return false;
    }
  }
  return true;
}

/// A square of texels, opaque and not, in front of a white one.
Scene square_before_another(std::uint8_t alpha) {
  Scene scene;
  Image<Rgba8> picture(2, 1, Rgba8{255, 0, 0, 255});
  picture.at(1, 0).a = alpha;
  Material front, back;
  front.base_colour = back.base_colour = glm::vec3(1.0f);
  front.specular = back.specular = glm::vec3(0.0f);
  front.texture = std::make_shared<const Texture>(picture);
  const std::uint32_t front_index = scene.add_material(front);
  const std::uint32_t back_index = scene.add_material(back);
  glm::dmat4 behind(1.0);
  behind[3].y = -0.5;
  scene.add(shapes::grid(2.0f, 1), glm::dmat4(1.0), front_index);
  scene.add(shapes::grid(2.0f, 1), behind, back_index);
  return scene;
}

Picture from_above(const Scene& scene) {
  ParallelWindow window;
  window.height = 1.9;
  const Camera camera = Camera::parallel(Pose::towards({0, 2, 0}, {0, 0, 0}, {0, 0, -1}), window, 0.1, 10.0);
  RenderSettings settings;
  settings.width = settings.height = 32;
  settings.texture_filter = TextureFilter::nearest;
  return render(scene, camera, settings);
}

}  // namespace

TEST_CASE("the texture filter is that of the settings, and a crop has the same bytes") {
  const Scene scene = load_scene("builtin:checkerboard");
  const Camera camera = over_the_board();
  const Picture nearest = render(scene, camera, settings_with(TextureFilter::nearest));
  const Picture bilinear = render(scene, camera, settings_with(TextureFilter::bilinear));
  const Picture trilinear = render(scene, camera, settings_with(TextureFilter::trilinear));
  CHECK_FALSE(is_equal(nearest.colour, bilinear.colour));
  CHECK_FALSE(is_equal(bilinear.colour, trilinear.colour));
  RenderSettings part = settings_with(TextureFilter::trilinear);
  part.crop = Rect{10, 12, 40, 30};
  CHECK(is_equal(trilinear.colour, render(scene, camera, part).colour, 10, 12));
}

TEST_CASE("a row just under the horizon is even, the lowest row has both colours in full") {
  const Picture picture =
      render(load_scene("builtin:checkerboard"), over_the_board(), settings_with(TextureFilter::trilinear));
  int horizon = 0;
  while (picture.triangle_id.at(48, horizon) == 0xFFFFFFFFu) ++horizon;
  const auto spread = [&](int y) {
    int least = 255, most = 0;
    for (int x = 0; x < 96; ++x) {
      if (picture.triangle_id.at(x, y) == 0xFFFFFFFFu) continue;
      least = std::min<int>(least, picture.colour.at(x, y).g);
      most = std::max<int>(most, picture.colour.at(x, y).g);
    }
    return most - least;
  };
  CHECK(spread(horizon + 1) <= 6);
  CHECK(spread(53) > 120);
}

TEST_CASE("transparent texels show what is behind them; opaque ones end the peeling") {
  const Picture holed = from_above(square_before_another(0));
  CHECK(holed.colour.at(8, 16).g == 0);
  CHECK(holed.colour.at(24, 16).g > 100);
  CHECK(holed.colour.at(24, 16).a == 255);
  CHECK(holed.counters.layers > 1);
  const Picture closed = from_above(square_before_another(255));
  CHECK(closed.colour.at(24, 16).g == 0);
  CHECK(closed.counters.layers == 1);
}
