#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "small_scenes.hpp"

using namespace velum;
using namespace velum::test;

namespace {

glm::dvec3 corner(const Scene& scene, const PickResult& picked, int i) {
  const Instance& instance = scene.instances()[picked.object];
  const Mesh& mesh = scene.meshes()[instance.mesh];
  const glm::dvec4 object(mesh.positions[mesh.triangles[picked.index][i]], 1.0);
  return glm::dvec3(instance.world_from_object * object);
}

double distance_to_ray(const Ray& ray, const glm::dvec3& point) {
  const glm::dvec3 along = ray.direction / glm::length(ray.direction);
  return glm::length(glm::cross(point - ray.origin, along));
}

constexpr const char* projections[] = {"perspective", "isometric", "cabinet", "military", "two-point"};

}  // namespace

TEST_CASE("what is picked is what the picture shows, and lies on the pixel's projector") {
  const Scene scene = meeting_solids();
  const RenderSettings settings = size(30, 20);
  for (const char* name : projections) {
    CAPTURE(name);
    const Camera camera = camera_of(scene, name, settings);
    const Picture picture = render(scene, camera, settings);
    int wrong = 0;
    double worst = 0.0;
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 30; ++x) {
        const auto picked = pick(picture, scene, camera, settings, x, y);
        wrong += picked.has_value() != (picture.triangle_id.at(x, y) != no_primitive);
        if (!picked) continue;
        const glm::dvec3 b = picked->barycentrics;
        wrong += picked->primitive != picture.triangle_id.at(x, y) ||
                 picked->object != picture.object_id.at(x, y) ||
                 static_cast<float>(picked->metric_depth) != picture.metric_depth.at(x, y) ||
                 std::abs(b.x + b.y + b.z - 1.0) > 1e-12 || std::min({b.x, b.y, b.z}) < 0.0;
        const glm::dvec3 sum = corner(scene, *picked, 0) * b.x + corner(scene, *picked, 1) * b.y +
                               corner(scene, *picked, 2) * b.z;
        wrong += glm::length(sum - picked->position) > 1e-12;
        worst = std::max(
            worst, distance_to_ray(unproject_ray(camera, settings, x + 0.5, y + 0.5), picked->position));
      }
    }
    CHECK(wrong == 0);
    CHECK(worst < 1e-3);  // snapping may show a centre that lies just outside its triangle
  }
}

TEST_CASE("picking without a picture, or in a crop, gives the same") {
  const Scene scene = meeting_solids();
  RenderSettings settings = size(30, 20);
  const Camera camera = camera_of(scene, "perspective", settings);
  const Picture whole = render(scene, camera, settings);
  const auto expected = pick(whole, scene, camera, settings, 16, 11);
  REQUIRE(expected.has_value());
  const auto alone = pick(scene, camera, settings, 16, 11);
  REQUIRE(alone.has_value());
  CHECK(alone->primitive == expected->primitive);
  CHECK(alone->position == expected->position);
  CHECK(alone->depth == expected->depth);
  settings.crop = Rect{10, 5, 12, 9};
  const auto cropped = pick(render(scene, camera, settings), scene, camera, settings, 16, 11);
  REQUIRE(cropped.has_value());
  CHECK(cropped->primitive == expected->primitive);
  CHECK(cropped->barycentrics == expected->barycentrics);
  CHECK_THROWS_AS(pick(scene, camera, settings, 9, 11), Error);
  CHECK_FALSE(pick(whole, scene, camera, size(30, 20), 0, 0).has_value());
}

TEST_CASE("unproject is the inverse of the way to the pixel") {
  const Scene scene = meeting_solids();
  const RenderSettings settings = size(30, 20);
  Random random{51};
  for (const char* name : projections) {
    CAPTURE(name);
    const Camera camera = camera_of(scene, name, settings);
    const glm::dmat4 clip_from_world = camera.viewing_transform(1.5).clip_from_world();
    double worst = 0.0;
    for (int i = 0; i < 100; ++i) {
      const double px = random.uniform(-3.0, 33.0), py = random.uniform(-3.0, 23.0), z = random.uniform();
      const glm::dvec4 clip = clip_from_world * glm::dvec4(unproject(camera, settings, px, py, z), 1.0);
      const glm::dvec2 pixel = Viewport{30, 20}.pixel_from_ndc(clip.x / clip.w, clip.y / clip.w);
      worst =
          std::max({worst, std::abs(pixel.x - px), std::abs(pixel.y - py), std::abs(clip.z / clip.w - z)});
    }
    CHECK(worst < 1e-9);
  }
}

TEST_CASE("a projector runs from the near to the far plane; a depth at infinity is an error") {
  const Camera camera = Camera::perspective({}, {}, 2.0, 4.0);
  const RenderSettings settings = size(10, 10);
  const Ray ray = unproject_ray(camera, settings, 5.0, 5.0);
  CHECK(glm::length(ray.origin - glm::dvec3(0, 0, -2)) < 1e-12);
  CHECK(glm::length(ray.at(1.0) - glm::dvec3(0, 0, -4)) < 1e-12);
  // z = far/(far - near) belongs to no finite distance: 2 here.
  CHECK_THROWS_AS(unproject(camera, settings, 5.0, 5.0, 2.0), Error);
}
