#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "base/error.hpp"
#include "drawing/sheet.hpp"
#include "pipeline/render.hpp"
#include "scene/builtin.hpp"

using namespace velum;

namespace {

Scene letter() {
  Scene scene;
  scene.add(shapes::letter_f());
  return scene;
}

std::map<std::string, SheetView> views_of(const Scene& scene, SheetLayout layout, SheetAngle angle) {
  SheetOptions options;
  options.layout = layout;
  options.angle = angle;
  std::map<std::string, SheetView> views;
  for (const SheetView& view : place_views(scene, options)) views.emplace(view.name, view);
  return views;
}

bool is_left_of(const SheetView& a, const SheetView& b) {
  return a.rect.right() <= b.rect.left && a.rect.top == b.rect.top && a.rect.height == b.rect.height;
}
bool is_above(const SheetView& a, const SheetView& b) {
  return a.rect.bottom() <= b.rect.top && a.rect.left == b.rect.left && a.rect.width == b.rect.width;
}

/// The pixels a view's object covers, on the sheet.
Rect object_box(const Scene& scene, const SheetView& view) {
  RenderSettings settings;
  settings.width = view.rect.width;
  settings.height = view.rect.height;
  Rect box = render(scene, view.camera, settings).bounding_box();
  box.left += view.rect.left;
  box.top += view.rect.top;
  return box;
}

}  // namespace

TEST_CASE("six views, first angle: top below, left to the right; third angle: the reverse") {
  const Scene scene = letter();
  const auto first = views_of(scene, SheetLayout::six, SheetAngle::first);
  REQUIRE(first.size() == 6);
  CHECK(is_above(first.at("front"), first.at("top")));
  CHECK(is_above(first.at("bottom"), first.at("front")));
  CHECK(is_left_of(first.at("front"), first.at("left")));
  CHECK(is_left_of(first.at("right"), first.at("front")));
  CHECK(is_left_of(first.at("left"), first.at("back")));
  const auto third = views_of(scene, SheetLayout::six, SheetAngle::third);
  CHECK(is_above(third.at("top"), third.at("front")));
  CHECK(is_above(third.at("front"), third.at("bottom")));
  CHECK(is_left_of(third.at("left"), third.at("front")));
  CHECK(is_left_of(third.at("front"), third.at("right")));
}

TEST_CASE("four panes: the perspective takes the free quadrant") {
  const Scene scene = letter();
  const auto third = views_of(scene, SheetLayout::four, SheetAngle::third);
  CHECK(is_above(third.at("top"), third.at("front")));
  CHECK(is_left_of(third.at("front"), third.at("right")));
  CHECK(is_above(third.at("perspective"), third.at("right")));
  const auto first = views_of(scene, SheetLayout::four, SheetAngle::first);
  CHECK(is_above(first.at("front"), first.at("top")));
  CHECK(is_left_of(first.at("right"), first.at("front")));
  CHECK(is_above(first.at("right"), first.at("perspective")));
}

TEST_CASE("the views share one scale and stand in line, measured in the pictures") {
  const Scene scene = letter();
  const glm::dvec3 size = scene.bounds().size();
  for (const SheetAngle angle : {SheetAngle::first, SheetAngle::third}) {
    const auto views = views_of(scene, SheetLayout::six, angle);
    const double scale = views.at("front").pixels_per_unit;
    std::map<std::string, Rect> boxes;
    for (const auto& [name, view] : views) boxes[name] = object_box(scene, view);
    const auto near = [](double a, double b) { return std::fabs(a - b) <= 1.0; };
    for (const char* name : {"front", "back"}) {
      CHECK(near(boxes[name].width, size.x * scale));
      CHECK(near(boxes[name].height, size.y * scale));
    }
    for (const char* name : {"left", "right"}) CHECK(near(boxes[name].width, size.z * scale));
    for (const char* name : {"top", "bottom"}) CHECK(near(boxes[name].height, size.z * scale));
    for (const char* name : {"left", "right", "back"}) CHECK(near(boxes[name].top, boxes["front"].top));
    for (const char* name : {"top", "bottom"}) CHECK(near(boxes[name].left, boxes["front"].left));
  }
}

TEST_CASE(
    "z-up scenes turn the views; a sheet too small for its views is an error; an empty scene gives an empty "
    "sheet") {
  Scene scene;
  scene.add(shapes::box(1.0f, 2.0f, 3.0f));
  scene.up = UpAxis::z;
  const auto views = views_of(scene, SheetLayout::six, SheetAngle::third);
  const Rect front = object_box(scene, views.at("front"));
  CHECK(static_cast<double>(front.height) / front.width == doctest::Approx(3.0).epsilon(0.02));
  SheetOptions tiny;
  tiny.width = 100;
  CHECK_THROWS_AS(place_views(scene, tiny), Error);
  CHECK(draw_sheet(Scene(), {}).views.size() == 6);
}
