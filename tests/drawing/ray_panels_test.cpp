#include "drawing/ray_panels.hpp"

#include <doctest/doctest.h>

#include <velum/velum.hpp>

using namespace velum;

namespace {

/// A traversal that goes down a level at each step of a digit string, e.g. "0123212"; '!' before a digit: the
/// hit.
std::vector<RayStep> traversal_of(const std::string& levels) {
  std::vector<RayStep> steps;
  bool is_hit = false;
  for (const char c : levels) {
    is_hit = is_hit || c == '!';
    if (c == '!') continue;
    RayStep step;
    step.level = c - '0';
    step.outcome = is_hit ? RayStep::Outcome::nearest : RayStep::Outcome::entered;
    is_hit = false;
    steps.push_back(step);
  }
  return steps;
}

using Places = std::vector<std::size_t>;

}  // namespace

TEST_CASE("panels go down in the order of the steps, and what was entered lowest gets one of its own") {
  const std::vector<RayPanel> panels = ray_panels(traversal_of("01234332123"), 2, 99, 99);
  REQUIRE(panels.size() == 3);
  CHECK(panels[0].steps == Places{0, 1, 2, 7, 8, 9});
  CHECK(panels[1].root == 2);
  CHECK(panels[1].steps == Places{2, 3, 4, 5, 6});
  CHECK(panels[2].steps == Places{9, 10});
}

TEST_CASE("every step is in a panel, none below the depth that was asked for") {
  const std::vector<RayStep> steps = traversal_of("012345654321234543212345");
  for (const int depth : {0, 1, 2, 4, 6, 99}) {
    CAPTURE(depth);
    std::vector<int> shown(steps.size(), 0);
    for (const RayPanel& panel : ray_panels(steps, 3, depth, 99)) {
      for (const std::size_t i : panel.steps) ++shown[i];
    }
    for (std::size_t i = 0; i < steps.size(); ++i)
      CHECK((shown[i] > 0) == (steps[i].level <= depth && depth > 0));
  }
}

TEST_CASE("of too many panels those are left that lead to the hit") {
  const std::vector<RayStep> steps = traversal_of("0121212!3123");
  const std::vector<RayPanel> panels = ray_panels(steps, 2, 99, 2);
  REQUIRE(panels.size() == 2);
  CHECK(panels[0].root == 0);
  CHECK(panels[1].root == 6);
  CHECK(ray_panels({}, 2, 99, 2).empty());
}

TEST_CASE("the drawing of a ray shows the hit in its panels, and a ray past everything has one") {
  Scene scene;
  scene.add(shapes::icosphere(1.0f, 2));
  const Camera camera = frame(scene.bounds(), parse_projection("perspective"), {});
  RenderSettings settings;
  settings.width = 40;
  settings.height = 30;
  const auto has_red = [&](int x, int y) {
    const Image<Rgba8> sheet = draw_ray(scene, explain_ray(scene, camera, settings, x, y));
    bool found = false;
    for (int row = 64; row < sheet.height(); ++row) {
      for (int i = 0; i < sheet.width(); ++i) {
        const Rgba8 c = sheet.at(i, row);
        found = found || (c.r > 190 && c.g < 40 && c.b < 40);
      }
    }
    return found;
  };
  CHECK(has_red(20, 15));
  CHECK_FALSE(has_red(0, 0));
}
