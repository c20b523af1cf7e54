// The drawing of what became of octree nodes shows the whole view volume, and its legend only where there is
// room.
#include <doctest/doctest.h>

#include <velum/velum.hpp>

using namespace velum;

namespace {

constexpr Rgba8 white{255, 255, 255, 255};
constexpr Rgba8 facing_away{235, 140, 20, 255};
constexpr Rgba8 volume{30, 70, 190, 255};

RenderSettings hierarchical() {
  RenderSettings settings;
  settings.width = 64;
  settings.height = 48;
  settings.visibility = VisibilityMethod::hierarchical;
  return settings;
}

int pixels_of(const Image<Rgba8>& picture, const Rgba8& colour) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) count += picture.at(x, y) == colour;
  }
  return count;
}

bool edge_is_white(const Image<Rgba8>& picture) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const bool is_edge = x < 2 || y < 2 || x >= picture.width() - 2 || y >= picture.height() - 2;
      if (is_edge && !(picture.at(x, y) == white)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("the view volume stays within the drawing of octree nodes, however far its far plane is") {
  Scene scene;
  scene.add(shapes::torus());
  const Pose poses[] = {Pose::towards({0.3, 0.4, 3.0}, {0, 0, 0}), Pose::towards({-2.0, 1.0, 0.5}, {0, 0, 0}),
                        Pose::towards({0.0, 4.0, 0.001}, {0, 0, 0})};
  for (const Pose& pose : poses) {
    for (const double far : {5.0, 1000.0}) {
      CAPTURE(pose.position.x);
      CAPTURE(far);
      const Image<Rgba8> seen = draw_octree(scene, Camera::perspective(pose, {VerticalAngle{0.7}}, 0.1, far),
                                            hierarchical(), 300, 200);
      CHECK(edge_is_white(seen));
      CHECK(pixels_of(seen, volume) > 200);
      const Image<Rgba8> parallel =
          draw_octree(scene, Camera::parallel(pose, {2.5}, -10.0, far), hierarchical(), 300, 200);
      CHECK(edge_is_white(parallel));
      CHECK(pixels_of(parallel, volume) > 200);
    }
  }
}

TEST_CASE("a drawing of octree nodes has its legend where there is room for it") {
  Scene scene;
  scene.add(shapes::torus());
  const Camera camera =
      Camera::perspective(Pose::towards({0, 0.4, 3}, {0, 0, 0}), {VerticalAngle{0.7}}, 0.1, 5.0);
  // Nothing is culled by facing, so only the legend has this colour.
  CHECK(pixels_of(draw_octree(scene, camera, hierarchical(), 160, 120), facing_away) == 0);
  const int small = pixels_of(draw_octree(scene, camera, hierarchical(), 480, 300), facing_away);
  const int large = pixels_of(draw_octree(scene, camera, hierarchical(), 1000, 600), facing_away);
  CHECK(small > 50);
  CHECK(large == 4 * small);
}
