// A crop is the same pixels for less work.
#include <doctest/doctest.h>

#include <velum/velum.hpp>

#include "small_scenes.hpp"

using namespace velum;
using namespace velum::test;

namespace {

/// A row of solids, lines among them, wide apart.
Scene row_of_things() {
  Scene scene;
  for (int i = 0; i < 8; ++i) scene.add(shapes::sphere(0.3f), moved({1.0 * i, 0.0, 0.0}));
  Mesh lines;
  lines.positions = {glm::vec3(-0.3f, -0.5f, 0), glm::vec3(0.3f, -0.5f, 0), glm::vec3(0, 0.5f, 0)};
  lines.segments = {glm::uvec2(0, 1)};
  lines.points = {2u};
  const std::uint32_t mesh = scene.add_mesh(lines);
  for (int i = 0; i < 8; ++i) {
    Instance instance;
    instance.mesh = mesh;
    instance.world_from_object = moved({1.0 * i, 0.0, 0.3});
    scene.add_instance(instance);
  }
  return scene;
}

bool is_part_of(const Picture& part, const Picture& whole, const Rect& crop) {
  for (int y = 0; y < crop.height; ++y) {
    for (int x = 0; x < crop.width; ++x) {
      const int u = crop.left + x, v = crop.top + y;
      if (part.triangle_id.at(x, y) != whole.triangle_id.at(u, v) ||
          part.depth.at(x, y) != whole.depth.at(u, v) || !(part.colour.at(x, y) == whole.colour.at(u, v))) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE("a crop equals its part of the picture, and what lies beside it is not transformed") {
  const Scene scene = row_of_things();
  for (const char* projection : {"front", "perspective", "cabinet", "isometric"}) {
    for (const VisibilityMethod method : {VisibilityMethod::zbuffer, VisibilityMethod::scanline}) {
      CAPTURE(projection);
      RenderSettings settings = size(240, 80);
      settings.visibility = method;
      settings.line_width = 9.0f;
      settings.point_size = 14.0f;
      const Camera camera = camera_of(scene, projection, settings);
      const Picture whole = render(scene, camera, settings);
      CHECK(whole.counters.instances == 16);
      CHECK(whole.counters.instances_beside == 0);
      for (const Isa isa : {Isa::best, Isa::reference}) {
        std::uint64_t beside = 0;
        for (int left = 0; left < 240; left += 16) {
          settings.isa = isa;
          settings.crop = Rect{left, left % 64, 16, 16};
          const Picture part = render(scene, camera, settings);
          CHECK(is_part_of(part, whole, *settings.crop));
          CHECK(part.counters.instances + part.counters.instances_beside == 16);
          CHECK(part.counters.vertices <= whole.counters.vertices);
          beside += part.counters.instances_beside;
        }
        CHECK(beside > 15 * 16 / 2);  // of each crop more than half of the scene, on average
        settings.crop.reset();
      }
    }
  }
}

TEST_CASE("the work for a crop shrinks with it, and all methods leave out the same") {
  const Scene scene = row_of_things();
  RenderSettings settings = size(240, 80);
  settings.isa = Isa::reference;
  const Camera camera = camera_of(scene, "front", settings);
  const Counters whole = render(scene, camera, settings).counters;
  settings.crop = Rect{100, 20, 40, 40};
  const Counters plain = render(scene, camera, settings).counters;
  CHECK(plain.vertices < whole.vertices / 2);
  CHECK(plain.triangles < whole.triangles / 2);
  CHECK(plain.pixels_tested < whole.pixels_tested / 2);
  CHECK(plain.fragments < whole.fragments / 2);
  CHECK(plain.pixels_shaded < whole.pixels_shaded / 2);
  settings.isa = Isa::best;
  const Counters vector = render(scene, camera, settings).counters;
  settings.visibility = VisibilityMethod::scanline;
  const Counters scanline = render(scene, camera, settings).counters;
  for (const Counters& other : {vector, scanline}) {
    CHECK(other.instances_beside == plain.instances_beside);
    CHECK(other.vertices == plain.vertices);
    CHECK(other.triangles == plain.triangles);
    CHECK(other.screen_triangles == plain.screen_triangles);
  }
}

TEST_CASE("a mesh around the eye, and one without vertices, are no trouble for a crop") {
  Scene scene = random_triangles(9, 200);
  scene.add(Mesh{});
  RenderSettings settings = size(64, 64);
  const Pose pose = Pose::towards({0.1, 0.2, 0.0}, {0.3, 0.1, -1.0});
  const Camera camera = Camera::perspective(pose, {VerticalAngle{1.4}}, 0.05, 20.0);
  const Picture whole = render(scene, camera, settings);
  settings.crop = Rect{40, 8, 16, 16};
  const Picture part = render(scene, camera, settings);
  CHECK(is_part_of(part, whole, *settings.crop));
  CHECK(part.counters.instances_beside == 0);
}
