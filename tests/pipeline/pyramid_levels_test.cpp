// Every level of the z-pyramid rejects something where it can, and it can where one of its cells holds no
// background.
#include <doctest/doctest.h>

#include <filesystem>
#include <numbers>
#include <string>
#include <velum/velum.hpp>

#include "small_scenes.hpp"

using namespace velum;

namespace {

constexpr int side = 64, levels = 7;

/// A square from the picture's upper left corner, in pixels of a picture of `side` pixels a side.
Mesh square(double left, double top, double size, double depth) {
  const auto corner = [&](double x, double y) {
    return glm::vec3(static_cast<float>(x), static_cast<float>(side - y), static_cast<float>(-depth));
  };
  Mesh mesh;
  mesh.positions = {corner(left, top), corner(left + size, top), corner(left + size, top + size),
                    corner(left, top + size)};
  mesh.triangles = {glm::uvec3(0, 2, 1), glm::uvec3(0, 3, 2)};
  return mesh;
}

/// Steps of a stair, one on the upper left cell of each level, the larger the farther; and behind each,
/// before the next one, a square that only this step hides.
Scene stair() {
  Scene scene;
  for (int level = 0; level < levels; ++level) {
    const double size = 1 << level;
    scene.add(square(0.0, 0.0, size, 2.0 * level + 1.0));
    scene.add(square(0.2 * size, 0.2 * size, 0.6 * size, 2.0 * level + 2.0));
  }
  return scene;
}

Camera stair_camera() {
  const Pose pose = Pose::towards({side / 2.0, side / 2.0, 0.0}, {side / 2.0, side / 2.0, -1.0});
  return Camera::parallel(pose, {static_cast<double>(side)}, 0.5, 40.0);
}

/// The second frame of a Renderer, which draws first what was seen.
Counters second_frame(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                      Picture* picture = nullptr) {
  Renderer renderer;
  renderer.render(scene, camera, settings);
  const Picture& second = renderer.render(scene, camera, settings);
  if (picture != nullptr) *picture = second;
  return second.counters;
}

/// The shared bunny a thousand times, as the benchmark has it.
Scene thousand_bunnies(const std::filesystem::path& file) {
  Scene scene = load_scene(file.string());
  const glm::dvec3 step = scene.bounds().size() * 1.2;
  const Instance one = scene.instances()[0];
  for (int i = 0; i < 1000; ++i) {
    const glm::dmat4 place =
        velum::test::moved(step * (glm::dvec3(i % 10, i / 10 % 10, i / 100) - 4.5)) * one.world_from_object;
    if (i == 0) {
      scene.set_world_from_object(0, place);
    } else {
      Instance next = one;
      next.world_from_object = place;
      scene.add_instance(next);
    }
  }
  return scene;
}

}  // namespace

TEST_CASE(
    "every level of the pyramid, the coarsest too, rejects what stands behind a picture without background") {
  const Scene scene = stair();
  RenderSettings settings = test::size(side, side);
  settings.visibility = VisibilityMethod::hierarchical;
  for (const Isa isa : {Isa::reference, Isa::best}) {
    settings.isa = isa;
    settings.hierarchy.use = HierarchyUse::both;
    const HierarchyCounters nodes = second_frame(scene, stair_camera(), settings).hierarchy;
    for (int i = 0; i < levels; ++i) {
      CAPTURE(i);
      CHECK(nodes.nodes_hidden_at[i] == 1);
    }
    CHECK(nodes.nodes_hidden == levels);
  }
  // By itself a polygon that covers no pixel, or hardly one, is not asked about.
  settings.hierarchy.use = HierarchyUse::polygons;
  settings.hierarchy.batch_size = 2;
  settings.isa = Isa::reference;
  const HierarchyCounters polygons = second_frame(scene, stair_camera(), settings).hierarchy;
  for (int i = 2; i < levels; ++i) {
    CAPTURE(i);
    CHECK(polygons.polygons_hidden_at[i] > 0);
  }
}

TEST_CASE("of a thousand bunnies four fifths are never transformed; every level that can reject does") {
  const std::filesystem::path file = std::filesystem::path(VELUM_SHARED_DATA) / "stanford-bunny.obj";
  if (!std::filesystem::exists(file)) {
    MESSAGE("the shared meshes are not beside the project: skipped");
    return;
  }
  const Scene scene = thousand_bunnies(file);
  const Camera camera = Camera::perspective(
      Pose::towards({1.83399398, 1.59082159, 2.21946438}, {-0.0168405008, 0.110154003, -0.0015369989}),
      {VerticalAngle{std::numbers::pi / 4.0}}, 0.147645515, 14.7645515);
  RenderSettings settings = test::size(1920, 1080);
  settings.visibility = VisibilityMethod::hierarchical;
  settings.shading = Shading::triangle_id;
  Picture picture;
  const HierarchyCounters counters = second_frame(scene, camera, settings, &picture).hierarchy;
  CHECK(counters.triangles_left_out >= scene.primitive_count() / 5 * 4);

  const Image<float> depth = reversed_depth_of(picture);
  ZPyramid pyramid;
  pyramid.build(depth.view());
  REQUIRE(pyramid.levels() == 12);
  for (int i = 0; i < pyramid.levels(); ++i) {
    CAPTURE(i);
    const bool can_hide = share_that_hides(pyramid, i) > 0.0;
    CHECK(can_hide == (i <= 8));  // cells of 512 pixels and more all show the empty sides of the picture
    CHECK((counters.nodes_hidden_at[i] > 0) == can_hide);
  }
}
