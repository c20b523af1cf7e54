#include <doctest/doctest.h>

#include <velum/velum.hpp>

#include "scene/expect_error.hpp"

using namespace velum;

namespace {

using Bytes = std::vector<std::byte>;

Scene two_meshes(float radius = 1.0f) {
  Scene scene;
  scene.add(shapes::sphere(radius, 12, 6));
  const std::uint32_t torus = scene.add_mesh(shapes::torus());
  for (int i = 0; i < 3; ++i) {
    glm::dmat4 placement(1.0);
    placement[3] = {2.0 * i - 2.0, 0.5, -1.0, 1.0};
    scene.add_instance({torus, 0, placement, ""});
  }
  return scene;
}

void expect_refusal(const Bytes& bytes, const Scene& scene, const std::string& why) {
  expect_error(ErrorKind::read, {"a.kd", why}, [&] { kd_trees_from_bytes(bytes, scene, "a.kd"); });
}

}  // namespace

TEST_CASE("a scene's kd-trees from a file give the same picture") {
  const Scene scene = two_meshes();
  const Camera camera = frame(scene.bounds(), parse_projection("perspective"), {});
  RenderSettings settings;
  settings.width = settings.height = 96;
  settings.visibility = VisibilityMethod::raycast;
  settings.accelerator = AcceleratorKind::kd_tree;
  const Picture built = render(scene, camera, settings);
  const Bytes bytes = kd_trees_bytes(SceneCaster(scene, AcceleratorKind::kd_tree));
  settings.caster = kd_trees_from_bytes(bytes, scene, "a.kd");
  settings.accelerator = AcceleratorKind::brute_force;  // is not looked at
  const Picture loaded = render(scene, camera, settings);
  CHECK(loaded.counters.ray_tests == built.counters.ray_tests);
  CHECK(kd_trees_bytes(*settings.caster) == bytes);
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 96; ++x) {
      REQUIRE(loaded.triangle_id.at(x, y) == built.triangle_id.at(x, y));
      REQUIRE(loaded.depth.at(x, y) == built.depth.at(x, y));
    }
  }
}

TEST_CASE("a scene's kd-trees: every truncation, every flipped bit and other scenes are refused") {
  const Scene scene = two_meshes();
  Bytes bytes = kd_trees_bytes(SceneCaster(scene, AcceleratorKind::kd_tree));
  const auto taken = [&](std::span<const std::byte> some) {
    try {
      kd_trees_from_bytes(some, scene, "a.kd");
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::read);
      return 0;
    }
    return 1;
  };
  int count = 0;
  for (std::size_t length = 0; length < bytes.size(); length += length < 200 ? 1 : 977)
    count += taken(std::span(bytes).first(length));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += bit < 1600 ? 1 : 7919) {
    const auto mask = static_cast<std::byte>(1u << bit % 8);
    bytes[bit / 8] ^= mask;
    count += taken(bytes);
    bytes[bit / 8] ^= mask;
  }
  CHECK(count == 0);
  CHECK(taken(bytes) == 1);
  expect_refusal(bytes, two_meshes(1.001f), "other triangles");
  Scene one;
  one.add(shapes::sphere(1.0f, 12, 6));
  expect_refusal(bytes, one, "2 meshes; the scene has 1");
  bytes.push_back(std::byte{0});
  expect_refusal(bytes, scene, "after its last tree");
}

TEST_CASE("a structure that was built for another scene is refused") {
  const Scene scene = two_meshes(), other = two_meshes();
  const Camera camera = frame(scene.bounds(), parse_projection("perspective"), {});
  RenderSettings settings;
  settings.width = settings.height = 16;
  settings.visibility = VisibilityMethod::raycast;
  settings.caster = std::make_shared<SceneCaster>(other, AcceleratorKind::bvh);
  expect_error(ErrorKind::usage, {"another scene"}, [&] { render(scene, camera, settings); });
}
