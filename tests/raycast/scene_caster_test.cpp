#include <doctest/doctest.h>

#include <algorithm>
#include <velum/velum.hpp>

#include "random_scenes.hpp"
#include "raycast/camera_rays.hpp"
#include "raycast/intersection/watertight.hpp"
#include "raycast/scene_caster.hpp"

using namespace velum;

namespace {

/// A viewing transform of one stage.
ViewingTransform alone(const glm::dmat4& matrix) {
  return ViewingTransform(StageList{{"matrix", "The caller's.", matrix}});
}

glm::dmat4 random_placement(Random& random, double away) {
  glm::dmat4 m(1.0);
  for (int axis = 0; axis < 3; ++axis) m[axis] = glm::dvec4(random_point(random), 0.0);
  m[3] = glm::dvec4(random_point(random) + glm::dvec3(away), 1.0);
  return m;
}

Scene random_scene(Random& random, int instances, double away) {
  Scene scene;
  scene.add_mesh(shapes::torus(0.5f, 0.2f, 12, 8));
  scene.add_mesh(shapes::house());
  for (int i = 0; i < instances; ++i) {
    Instance instance;
    instance.mesh = static_cast<std::uint32_t>(random.below(2));
    instance.world_from_object = random_placement(random, away);
    scene.add_instance(instance);
  }
  return scene;
}

/// All hits by testing every world triangle with the teaching routine.
std::vector<SceneHit> world_hits(const Scene& scene, const Ray& ray) {
  std::vector<SceneHit> hits;
  for (std::uint32_t id = 0; id < scene.primitive_count(); ++id) {
    const PrimitivePlace place = scene.place(id);
    const Instance& instance = scene.instances()[place.instance];
    const Mesh& mesh = scene.meshes()[instance.mesh];
    const auto world = [&](std::uint32_t v) {
      return glm::dvec3(instance.world_from_object * glm::dvec4(glm::dvec3(mesh.positions[v]), 1.0));
    };
    const glm::uvec3& t = mesh.triangles[place.index];
    const auto hit = intersect_moller_trumbore(ray, {world(t.x), world(t.y), world(t.z)});
    if (hit && hit->t >= 0.0) hits.push_back({hit->t, id, place.instance, place.index, hit->barycentric});
  }
  std::sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  return hits;
}

constexpr Interval ahead{0.0, 1e300};

}  // namespace

TEST_CASE("a scene of instances is hit where its world triangles are, for every structure") {
  Random random{41};
  int hits = 0;
  for (const double away : {0.0, 1e4}) {
    const Scene scene = random_scene(random, 12, away);
    for (const AcceleratorName& name : accelerator_names()) {
      CAPTURE(name.name);
      const SceneCaster caster(scene, name.kind);
      Random rays{42};
      for (int i = 0; i < 30; ++i) {
        Ray ray = random_ray(rays);
        ray.origin += away;
        const std::vector<SceneHit> expected = world_hits(scene, ray);
        CastCounters counters;
        std::vector<SceneHit> all;
        caster.all_hits(ray, ahead, counters, all);
        REQUIRE(all.size() == expected.size());
        for (std::size_t k = 0; k < all.size(); ++k) {
          CHECK(all[k].primitive == expected[k].primitive);
          CHECK(all[k].t == doctest::Approx(expected[k].t).epsilon(1e-8));
        }
        const SceneHit first = caster.first_hit(ray, ahead, counters);
        CHECK(first.is_hit() == !expected.empty());
        if (first.is_hit()) CHECK(first.primitive == expected[0].primitive);
        CHECK(caster.is_blocked(ray, ahead, counters) == !expected.empty());
        CHECK(counters.rays == 3);
        hits += first.is_hit();
      }
    }
  }
  CHECK(hits > 100);
}

TEST_CASE("rays cast together into a scene hit what each hits alone, with few instances and with many") {
  Random random{43};
  int hits = 0;
  for (const int instances : {1, 3, 4, 12}) {
    const Scene scene = random_scene(random, instances, 0.0);
    for (const Isa isa : available_isas()) {
      const SceneCaster caster(scene, AcceleratorKind::bvh, isa);
      Random rays_random{44};
      for (int i = 0; i < 30; ++i) {
        std::vector<ViewRay> rays(11, {random_ray(rays_random), ahead});
        for (ViewRay& ray : rays) ray.ray.origin += random_point(rays_random, 0.05);
        std::vector<SceneHit> together(rays.size());
        CastCounters counters, alone;
        caster.first_hits(rays, together, counters);
        for (std::size_t k = 0; k < rays.size(); ++k) {
          const SceneHit one = caster.first_hit(rays[k].ray, rays[k].range, alone);
          CHECK(together[k].primitive == one.primitive);
          CHECK(together[k].instance == one.instance);
          CHECK(together[k].t == one.t);
        }
        CHECK(counters.rays == rays.size());
        CHECK(counters.hits == alone.hits);
        hits += static_cast<int>(alone.hits);
      }
    }
  }
  CHECK(hits > 1000);
}

TEST_CASE("of instances in the same place the first one is hit") {
  Scene scene;
  const std::uint32_t mesh = scene.add_mesh(shapes::cube(1.0f));
  for (int i = 0; i < 5; ++i) scene.add_instance({mesh, 0, glm::dmat4(1.0), ""});
  for (const AcceleratorName& name : accelerator_names()) {
    CastCounters counters;
    const SceneCaster caster(scene, name.kind);
    CHECK(caster.first_hit({{0.1, 0.2, 5}, {0, 0, -1}}, ahead, counters).instance == 0);
    CHECK(caster.memory() < 100000);
  }
}

TEST_CASE("a closed surface is met an even number of times, also through its edges and corners") {
  Scene scene;
  scene.add(shapes::cube(2.0f));
  const SceneCaster caster(scene, AcceleratorKind::bvh);
  CastCounters counters;
  std::vector<SceneHit> all;
  for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      caster.all_hits({{x, y, 4}, {0, 0, -1}}, ahead, counters, all);
      CHECK(all.size() % 2 == 0);
      if (x * x < 1.0 && y * y < 1.0) CHECK(all.size() == 2);
      if (x * x < 1.0 && y * y < 1.0) CHECK(all[0].t == doctest::Approx(3.0));
    }
  }
}

TEST_CASE("a structure knows the scene it was built from") {
  Random random{43};
  Scene scene = random_scene(random, 3, 0.0);
  const SceneCaster caster(scene, AcceleratorKind::bvh);
  CHECK(caster.is_of(scene));
  const Scene copy = scene;
  CHECK(caster.is_of(copy));  // shares the meshes
  scene.set_world_from_object(1, glm::dmat4(1.0));
  CHECK_FALSE(caster.is_of(scene));
}

TEST_CASE("camera rays run from the near to the far plane through what the picture shows there") {
  for (const ProjectionEntry& entry : projection_catalogue()) {
    CAPTURE(entry.name);
    Scene scene;
    scene.add(shapes::house());
    const Camera camera = frame(scene.bounds(), parse_projection(entry.name), {});
    const ViewingTransform viewing = camera.viewing_transform(camera.aspect().value_or(1.5));
    const Viewport viewport{60, 40};
    const CameraRays rays(viewing, viewport);
    for (const glm::dvec2 pixel : {glm::dvec2(0.5, 0.5), glm::dvec2(30, 20), glm::dvec2(59.5, 3.25)}) {
      const ViewRay view_ray = rays.through(pixel.x, pixel.y);
      for (const double t : {0.0, 0.25, 1.0}) {
        const glm::dvec4 clip = viewing.clip_from_world() * glm::dvec4(view_ray.ray.at(t), 1.0);
        const glm::dvec2 back = viewport.pixel_from_ndc(clip.x / clip.w, clip.y / clip.w);
        CHECK(back.x == doctest::Approx(pixel.x));
        CHECK(back.y == doctest::Approx(pixel.y));
        if (t != 0.25) CHECK(clip.z / clip.w == doctest::Approx(t));
      }
      CHECK(view_ray.range.lower == 0.0);
      CHECK(view_ray.range.upper == 1.0);
    }
  }
}

TEST_CASE("camera rays keep their direction where far / near takes nearly all digits of double") {
  const Pose pose = Pose::towards({120.0, -35.0, 60.0}, {3.0, 1.0, -2.0});
  for (const double near : {1e-2, 1e-6, 1e-9}) {
    for (const double angle : {1.0, 1e-4}) {
      CAPTURE(near);
      CAPTURE(angle);
      const Viewport viewport{60, 40};
      const ViewingTransform viewing =
          Camera::perspective(pose, {VerticalAngle{angle}}, near, 500.0).viewing_transform(1.5);
      const CameraRays rays(viewing, viewport);
      const glm::dmat4 clip_from_world = viewing.clip_from_world();
      for (const glm::dvec2 pixel : {glm::dvec2(0.5, 0.5), glm::dvec2(30, 20), glm::dvec2(59.5, 3.25)}) {
        const ViewRay view_ray = rays.through(pixel.x, pixel.y);
        const double length = glm::length(view_ray.ray.direction);
        const glm::dvec3 at = view_ray.ray.origin + view_ray.ray.direction * (100.0 / length);
        const glm::dvec4 clip = clip_from_world * glm::dvec4(at, 1.0);
        const glm::dvec2 back = viewport.pixel_from_ndc(clip.x / clip.w, clip.y / clip.w);
        CHECK(std::fabs(back.x - pixel.x) < 1e-6);
        CHECK(std::fabs(back.y - pixel.y) < 1e-6);
      }
    }
  }
}

TEST_CASE("camera rays of an infinite far plane, and of a near plane at infinity") {
  glm::dmat4 infinite(0.0);  // z = w - near: 0 at the near plane, w at infinity
  infinite[0][0] = infinite[1][1] = 1.0;
  infinite[2][2] = infinite[2][3] = -1.0;
  infinite[3][2] = -0.5;
  const ViewRay ray = CameraRays(alone(infinite), {10, 10}).through(7.5, 2.5);
  CHECK(ray.range.lower == 0.0);
  CHECK(ray.range.upper == std::numeric_limits<double>::infinity());
  CHECK(ray.ray.origin.z == doctest::Approx(-0.5));
  CHECK(ray.ray.direction.z < 0.0);
  CHECK(ray.ray.direction.x == doctest::Approx(-0.5 * ray.ray.direction.z));
  CHECK(ray.ray.direction.y == doctest::Approx(-0.5 * ray.ray.direction.z));

  glm::dmat4 reversed = infinite;  // z' = w - z
  for (int column = 0; column < 4; ++column) reversed[column][2] = infinite[column][3] - infinite[column][2];
  const ViewRay back = CameraRays(alone(reversed), {10, 10}).through(7.5, 2.5);
  CHECK(back.range.lower == -std::numeric_limits<double>::infinity());
  CHECK(back.range.upper == 0.0);
  CHECK(back.ray.origin.z == doctest::Approx(-0.5));
  CHECK(back.ray.direction.z > 0.0);
}
