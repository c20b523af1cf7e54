#include "projection/frame.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "base/elementary.hpp"
#include "base/error.hpp"
#include "matrices.hpp"

using namespace velum;
namespace named = velum::projection;

namespace {

struct NamedBox {
  const char* name;
  Aabb box;
};

const NamedBox boxes[] = {
    {"cube", {{0, 0, 0}, {1, 1, 1}}},
    {"long", {{-5, 1, 2}, {9, 2, 3}}},
    {"tall", {{-1, 0, -1}, {1, 12, 1}}},
    {"flat in x", {{2, 0, 0}, {2, 1, 1}}},
    {"flat in y", {{0, 2, 0}, {3, 2, 1}}},
    {"flat in z", {{0, 0, 2}, {1, 3, 2}}},
    {"line in x", {{-1, 0, 0}, {4, 0, 0}}},
    {"line in y", {{0, -1, 0}, {0, 4, 0}}},
    {"line in z", {{0, 0, -1}, {0, 0, 4}}},
    {"point", {{3, 4, 5}, {3, 4, 5}}},
    {"origin", {{0, 0, 0}, {0, 0, 0}}},
    {"empty", {}},
    {"huge", {{-1e30, -2e30, 0}, {1e30, 2e30, 1e30}}},
    {"tiny", {{-1e-30, -2e-30, 0}, {1e-30, 2e-30, 1e-30}}},
    {"far off", {{1e4, 1e4, 1e4}, {1e4 + 1, 1e4 + 2, 1e4 + 1}}},
};

struct Extent {
  glm::dvec3 lower{std::numeric_limits<double>::infinity()};
  glm::dvec3 upper{-std::numeric_limits<double>::infinity()};
};

Extent picture_of(const Camera& camera, const Aabb& box, double aspect) {
  const glm::dmat4 clip = camera.viewing_transform(aspect).clip_from_world();
  Extent extent;
  for (const glm::dvec3& corner : box.corners()) {
    const glm::dvec3 p = canonical(clip, corner);
    extent.lower = glm::min(extent.lower, p);
    extent.upper = glm::max(extent.upper, p);
  }
  return extent;
}

double largest_edge(const Aabb& box) {
  return glm::max(box.size().x, glm::max(box.size().y, box.size().z));
}

void check_inside(const Extent& extent, double margin, double tolerance) {
  const double edge = 1 - 2 * margin + tolerance;
  CHECK(extent.lower.x >= -edge);
  CHECK(extent.lower.y >= -edge);
  CHECK(extent.upper.x <= edge);
  CHECK(extent.upper.y <= edge);
  CHECK(extent.lower.z >= 0.0);
  CHECK(extent.upper.z <= 1.0);
}

// Near and far leave only the pad around the corners.
void check_tight_depth(const Camera& camera, const Aabb& box) {
  const glm::dvec4 plane = metric_depth_plane(camera);
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
  for (const glm::dvec3& corner : box.corners()) {
    nearest = glm::min(nearest, glm::dot(plane, glm::dvec4(corner, 1)));
    farthest = glm::max(farthest, glm::dot(plane, glm::dvec4(corner, 1)));
  }
  const double pad = 2.1e-3 * largest_edge(box);
  CHECK(camera.near() > 0.0);
  CHECK(camera.near() < nearest);
  CHECK(camera.near() > nearest - pad);
  CHECK(camera.far() > farthest);
  CHECK(camera.far() < farthest + pad);
}

std::vector<Projection> all_projections() {
  std::vector<Projection> result;
  for (const ProjectionEntry& entry : projection_catalogue()) result.push_back(parse_projection(entry.name));
  return result;
}

FrameOptions options(double aspect = 1.0) {
  FrameOptions result;
  result.aspect = aspect;
  return result;
}

double vertical_angle_of(const Camera& camera) {
  return std::get<VerticalAngle>(std::get<PerspectiveLens>(camera.lens()).opening).radians;
}

}  // namespace

TEST_CASE("every projection frames every box: inside the margin, touching it, near and far tight") {
  for (const Projection& projection : all_projections()) {
    for (const NamedBox& named_box : boxes) {
      for (const double aspect : {1.0, 16.0 / 9.0, 0.4}) {
        for (const bool z_up : {false, true}) {
          CAPTURE(projection.name);
          CAPTURE(named_box.name);
          CAPTURE(aspect);
          CAPTURE(z_up);
          FrameOptions o = options(aspect);
          o.z_up = z_up;
          const Camera camera = frame(named_box.box, projection, o);
          if (named_box.box.is_empty()) continue;
          const Extent extent = picture_of(camera, named_box.box, aspect);
          check_inside(extent, o.margin, 1e-9);
          const double edge = largest_edge(named_box.box);
          if (edge == 0.0) continue;
          check_tight_depth(camera, named_box.box);
          const double reach =
              glm::max(glm::max(extent.upper.x, extent.upper.y), -glm::min(extent.lower.x, extent.lower.y));
          if (std::string(named_box.name).find("line") == std::string::npos) {
            CHECK(reach == doctest::Approx(1 - 2 * o.margin).epsilon(1e-9));  // the tight axis touches
          }
          // What is free is shared equally by both sides.
          if (named_box.name == std::string("cube")) {
            CHECK(std::abs(extent.upper.x + extent.lower.x) < 1e-9);
            CHECK(std::abs(extent.upper.y + extent.lower.y) < 1e-9);
          }
        }
      }
    }
  }
}

TEST_CASE("an empty box is framed as a unit cube, a point as a small box") {
  const Camera empty = frame(Aabb{}, named::front());
  CHECK(picture_of(empty, {glm::dvec3(-0.5), glm::dvec3(0.5)}, 1).upper.x == doctest::Approx(0.9));
  const Camera point = frame({{3, 4, 5}, {3, 4, 5}}, named::isometric());
  CHECK(glm::length(canonical(point.viewing_transform(1).clip_from_world(), {3, 4, 5}) -
                    glm::dvec3(0, 0, 0.5)) < 0.2);
}

TEST_CASE("the margin is the empty share at each side") {
  for (const double margin : {0.0, 0.1, 0.3}) {
    FrameOptions o;
    o.margin = margin;
    for (const Projection& projection : all_projections()) {
      CAPTURE(projection.name);
      const Extent extent = picture_of(frame(boxes[0].box, projection, o), boxes[0].box, 1);
      const double reach = glm::max(extent.upper.x, extent.upper.y);
      CHECK(reach == doctest::Approx(1 - 2 * margin).epsilon(1e-12));
    }
  }
}

TEST_CASE("with z up, the front view looks along +y and z is up on the picture") {
  FrameOptions o;
  o.z_up = true;
  const Camera front = frame(boxes[0].box, named::front(), o);
  CHECK(front.pose().look == glm::dvec3(0, 1, 0));
  CHECK(front.pose().up == glm::dvec3(0, 0, 1));
  const Camera top = frame(boxes[0].box, named::top(), o);
  CHECK(top.pose().look == glm::dvec3(0, 0, -1));
  CHECK(top.pose().up == glm::dvec3(0, 1, 0));
}

TEST_CASE("two-point perspective draws verticals vertical, one-point a true front face") {
  const glm::dmat4 two =
      frame(boxes[1].box, named::two_point(), options(1.5)).viewing_transform(1.5).clip_from_world();
  for (const double x : {-5.0, 3.0, 9.0}) {
    CHECK(canonical(two, {x, 1, 3}).x == doctest::Approx(canonical(two, {x, 2, 3}).x).epsilon(1e-13));
  }
  const glm::dmat4 one = frame(boxes[0].box, named::one_point()).viewing_transform(1).clip_from_world();
  CHECK(canonical(one, {0, 0, 1}).x == doctest::Approx(canonical(one, {0, 1, 1}).x).epsilon(1e-13));
  CHECK(canonical(one, {0, 0, 1}).y == doctest::Approx(canonical(one, {1, 0, 1}).y).epsilon(1e-13));
}

TEST_CASE("one- and two-point perspective keep the eye on its line and shift the lens") {
  const Camera one = frame(boxes[0].box, named::one_point());
  const glm::dvec3 to_eye = glm::normalize(one.pose().position - boxes[0].box.centre());
  CHECK(glm::length(to_eye - named::one_point().to_eye) < 1e-12);
  const Camera two = frame(boxes[0].box, named::two_point());
  CHECK(std::get<PerspectiveLens>(two.lens()).shift.x == 0.0);
  CHECK(std::get<PerspectiveLens>(two.lens()).shift.y < 0.0);
}

TEST_CASE("oblique framing keeps the plane through the box's centre in place") {
  const Camera camera = frame(boxes[4].box, named::cabinet());
  const glm::dvec3 centre = canonical(camera.viewing_transform(1).clip_from_world(), boxes[4].box.centre());
  CHECK(std::abs(centre.x) < 1e-14);
  CHECK(std::abs(centre.y) < 1e-14);
}

TEST_CASE("a user's eye looks at the box's centre with an angle that holds the box") {
  for (const double aspect : {1.0, 2.0}) {
    FrameOptions o = options(aspect);
    o.eye = glm::dvec3(3, 2, 5);
    const Camera camera = frame(boxes[0].box, named::perspective(), o);
    CHECK(camera.pose().position == *o.eye);
    const Extent extent = picture_of(camera, boxes[0].box, aspect);
    check_inside(extent, o.margin, 1e-12);
    CHECK(glm::max(glm::max(extent.upper.x, extent.upper.y), -glm::min(extent.lower.x, extent.lower.y)) ==
          doctest::Approx(0.9).epsilon(1e-12));
    check_tight_depth(camera, boxes[0].box);
    const glm::dvec3 centre =
        canonical(camera.viewing_transform(aspect).clip_from_world(), boxes[0].box.centre());
    CHECK(std::abs(centre.x) < 1e-14);
    CHECK(std::abs(centre.y) < 1e-14);
  }
}

TEST_CASE("an eye too close or inside gets 60 degrees, and a near plane in front of it") {
  FrameOptions o;
  o.eye = glm::dvec3(0.5, 0.5, 1.2);
  CHECK(vertical_angle_of(frame(boxes[0].box, named::perspective(), o)) == radians(60));
  o.eye = boxes[0].box.centre();
  const Camera inside = frame(boxes[0].box, named::perspective(), o);
  CHECK(vertical_angle_of(inside) == radians(60));
  CHECK(inside.near() > 0.0);
  CHECK(inside.near() <= 1.001e-4 * inside.far());
}

TEST_CASE("a box wholly behind a user's eye still makes a valid camera") {
  FrameOptions o;
  o.eye = glm::dvec3(0, 0, 5);
  o.target = glm::dvec3(0, 0, 10);
  for (const Projection& projection : all_projections()) {
    CAPTURE(projection.name);
    const Camera camera = frame(boxes[0].box, projection, o);
    CHECK(camera.near() >= 0.0);
    const glm::dmat4 clip = camera.viewing_transform(1).clip_from_world();
    const glm::dvec4 centre = clip * glm::dvec4(boxes[0].box.centre(), 1);
    CHECK((centre.w < 0.0 || centre.z < 0.0));
  }
}

TEST_CASE("every option overrides its part; the rest is still framed") {
  FrameOptions o;
  o.eye = glm::dvec3(4, 3, 8);
  o.target = glm::dvec3(1, 0, 0);
  o.up = glm::dvec3(1, 0, 0);
  o.vertical_angle = 0.5;
  o.near = 0.25;
  o.far = 75.0;
  const Camera camera = frame(boxes[0].box, named::perspective(), o);
  CHECK(camera.pose().position == *o.eye);
  CHECK(glm::length(glm::normalize(camera.pose().look) - glm::normalize(*o.target - *o.eye)) < 1e-14);
  CHECK(glm::dot(camera.pose().up, glm::dvec3(1, 0, 0)) > 0.5);
  CHECK(vertical_angle_of(camera) == 0.5);
  CHECK(camera.near() == 0.25);
  CHECK(camera.far() == 75.0);

  FrameOptions wide;
  wide.horizontal_angle = 1.5;
  wide.aspect = 2.0;
  const Camera by_width = frame(boxes[0].box, named::two_point(), wide);
  CHECK(std::get<HorizontalAngle>(std::get<PerspectiveLens>(by_width.lens()).opening).radians == 1.5);
  check_inside(picture_of(by_width, boxes[0].box, 2.0), wide.margin, 1e-12);

  for (const Projection& projection : all_projections()) {
    CAPTURE(projection.name);
    FrameOptions aimed;
    aimed.target = glm::dvec3(1, 1, 1);
    const Camera at_target = frame(boxes[0].box, projection, aimed);
    check_inside(picture_of(at_target, boxes[0].box, 1), aimed.margin, 1e-12);
    if (projection.vanishing_points != 0) continue;  // these shift the lens to hold the box
    const glm::dvec3 target = canonical(at_target.viewing_transform(1).clip_from_world(), *aimed.target);
    CHECK(std::abs(target.x) < 1e-13);
    CHECK(std::abs(target.y) < 1e-13);
  }
}

TEST_CASE("a parallel projection from eye and target looks from one to the other, and holds the box") {
  FrameOptions o = options(1.5);
  o.eye = glm::dvec3(4, 3, 8);
  o.target = glm::dvec3(0.5, 0.5, 0.5);
  for (const Projection& projection : {named::isometric(), named::cabinet(), named::top()}) {
    const Camera camera = frame(boxes[0].box, projection, o);
    CHECK(camera.pose().position == *o.eye);
    CHECK(glm::length(glm::normalize(camera.pose().look) - glm::normalize(*o.target - *o.eye)) < 1e-14);
    check_inside(picture_of(camera, boxes[0].box, 1.5), o.margin, 1e-12);
    check_tight_depth(camera, boxes[0].box);
  }
}

TEST_CASE("looking straight down or up finds an up of its own") {
  FrameOptions o;
  o.eye = glm::dvec3(0.5, 9, 0.5);
  CHECK(frame(boxes[0].box, named::perspective(), o).pose().up.z < -0.5);
  CHECK(frame(boxes[0].box, named::top(), o).pose().up == glm::dvec3(0, 0, -1));
  o.eye = glm::dvec3(0.5, -9, 0.5);
  CHECK(frame(boxes[0].box, named::front(), o).pose().up == glm::dvec3(0, 0, 1));
  o.up = glm::dvec3(0, 1, 0);
  CHECK_THROWS_AS(frame(boxes[0].box, named::front(), o), Error);
}

TEST_CASE(
    "with a user's eye, one- and two-point perspective keep their vanishing points and centre the box") {
  FrameOptions o;
  o.eye = glm::dvec3(3, 4, 9);
  const glm::dvec3 centre = boxes[0].box.centre();
  const Camera one = frame(boxes[0].box, named::one_point(), o);
  CHECK(one.pose().look == glm::dvec3(0, 0, -1));
  const Camera two = frame(boxes[0].box, named::two_point(), o);
  CHECK(two.pose().look.y == 0.0);
  for (const Camera& camera : {one, two}) check_inside(picture_of(camera, boxes[0].box, 1), o.margin, 1e-12);
  o.target = centre;
  const glm::dmat4 aimed = frame(boxes[0].box, named::one_point(), o).viewing_transform(1).clip_from_world();
  CHECK(glm::length(glm::dvec2(canonical(aimed, centre))) < 1e-13);
}

TEST_CASE("a user's near or far beyond the box still makes a valid camera") {
  for (const Projection& projection : {named::front(), named::perspective(), named::one_point()}) {
    FrameOptions beyond;
    beyond.near = 1e6;
    CHECK(frame(boxes[0].box, projection, beyond).near() == 1e6);
    FrameOptions before;
    before.far = 1e-6;
    CHECK(frame(boxes[0].box, projection, before).far() == 1e-6);
  }
}

TEST_CASE("options that cannot be met are refused by name") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [](const char* name, const Projection& projection, auto change) {
    CAPTURE(name);
    FrameOptions o;
    change(o);
    try {
      frame(boxes[0].box, projection, o);
      FAIL("accepted");
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::usage);
      CHECK(std::string(error.what()).find(name) != std::string::npos);
    }
  };
  const Projection perspective = named::perspective();
  refuses("aspect", perspective, [](FrameOptions& o) { o.aspect = 0; });
  refuses("margin", perspective, [](FrameOptions& o) { o.margin = 0.5; });
  refuses("margin", perspective, [&](FrameOptions& o) { o.margin = nan; });
  refuses("eye", perspective, [&](FrameOptions& o) { o.eye = glm::dvec3(0, nan, 0); });
  refuses("target", perspective, [](FrameOptions& o) { o.eye = o.target = glm::dvec3(1); });
  refuses("up", perspective, [](FrameOptions& o) { o.up = glm::dvec3(0); });
  refuses("opening angle", perspective, [](FrameOptions& o) { o.vertical_angle = o.horizontal_angle = 1.0; });
  refuses("opening angle", perspective, [](FrameOptions& o) { o.vertical_angle = 3.2; });
  refuses("opening angle", named::cabinet(), [](FrameOptions& o) { o.vertical_angle = 1.0; });
  refuses("near", perspective, [](FrameOptions& o) { o.near = 2, o.far = 1; });
  refuses("near", named::front(), [](FrameOptions& o) { o.near = 1, o.far = 1; });
  refuses("near", perspective, [](FrameOptions& o) { o.near = 0; });
  refuses("far", perspective, [](FrameOptions& o) { o.far = -1; });
  CHECK_THROWS_AS(frame({{0, 0, 0}, {1e100, 1, 1}}, perspective), Error);
}
