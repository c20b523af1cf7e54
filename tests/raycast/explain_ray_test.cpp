#include <doctest/doctest.h>

#include <velum/velum.hpp>

using namespace velum;

namespace {

Scene two_tori() {
  Scene scene;
  const std::uint32_t mesh = scene.add_mesh(shapes::torus(0.5f, 0.2f, 16, 10));
  glm::dmat4 behind(1.0);
  behind[3] = {0.1, 0.1, -1.0, 1.0};
  scene.add_instance({mesh, 0, behind, ""});
  scene.add_instance({mesh, 0, glm::dmat4(1.0), ""});
  return scene;
}

}  // namespace

TEST_CASE("a ray is explained as it is cast: same hit, in order, and the nearest step is the hit") {
  const Scene scene = two_tori();
  const Camera camera = frame(scene.bounds(), parse_projection("perspective"), {});
  RenderSettings settings;
  settings.width = 40;
  settings.height = 30;
  settings.shading = Shading::triangle_id;
  settings.visibility = VisibilityMethod::raycast;
  settings.accelerator = AcceleratorKind::binary_bvh;
  int hits = 0;
  for (const Cull cull : {Cull::none, Cull::back}) {
    settings.cull = cull;
    const Picture picture = render(scene, camera, settings);
    for (int y = 0; y < 30; y += 3) {
      for (int x = 0; x < 40; x += 3) {
        const RayExplanation ray = explain_ray(scene, camera, settings, x, y);
        CHECK(ray.hit.primitive == picture.triangle_id.at(x, y));
        CHECK(ray.hits.empty() == !ray.hit.is_hit());
        if (ray.hit.is_hit()) CHECK(ray.hits[0].primitive == ray.hit.primitive);
        std::uint32_t nearest = no_primitive;
        std::uint64_t tests = 0;
        for (const RayStep& step : ray.traversal) {
          if (step.outcome == RayStep::Outcome::nearest) nearest = step.index;
          tests += step.kind == RayStep::Kind::triangle;
        }
        CHECK(nearest == ray.hit.primitive);
        CHECK(tests == ray.counters.tests);
        hits += ray.hit.is_hit();
      }
    }
  }
  CHECK(hits > 30);
  CHECK_THROWS_AS(explain_ray(scene, camera, settings, 40, 0), Error);
}
