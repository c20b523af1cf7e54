#include <doctest/doctest.h>

#include <velum/velum.hpp>

#include "base/contract.hpp"
#include "pipeline/agree_analytic.hpp"

using namespace velum;

namespace {

AnalyticAgreement compare(const Mesh& mesh, const AnalyticBody& body, const char* projection,
                          const glm::dmat4& placement = glm::dmat4(1.0)) {
  Scene scene;
  scene.add(mesh, placement);
  RenderSettings settings;
  settings.width = settings.height = 200;
  const Camera camera = frame(scene.bounds(), parse_projection(projection), {});
  return agree_analytic(scene, std::array{body}, camera, settings);
}

constexpr const char* projections[] = {"perspective", "isometric", "cabinet"};

}  // namespace

TEST_CASE(
    "a sphere of triangles differs from the sphere at the silhouette only, four times less when it doubles") {
  for (const char* projection : projections) {
    CAPTURE(projection);
    std::uint64_t before = 0;
    double share_before = 0.0;
    for (const int segments : {12, 24, 48}) {
      const AnalyticAgreement a = compare(shapes::sphere(1.0f, segments, segments / 2), Sphere{}, projection);
      CHECK(a.unexplained == 0);
      CHECK(a.covered > 5000);
      CHECK(a.silhouette > 10);
      if (before != 0) {
        CHECK(a.silhouette * 5 < before * 2);
        CHECK((1.0 - a.inner_share) / (1.0 - share_before) == doctest::Approx(0.25).epsilon(0.1));
      }
      before = a.silhouette;
      share_before = a.inner_share;
    }
  }
}

TEST_CASE("an ellipsoid and a cylinder are compared in their object space") {
  glm::dmat4 squashed(1.0);
  squashed[0][0] = 2.0;
  squashed[1][1] = 0.6;
  squashed[1][0] = 0.3;
  squashed[3] = {4.0, -1.0, 2.0, 1.0};
  for (const char* projection : projections) {
    CAPTURE(projection);
    CHECK(compare(shapes::icosphere(1.0f, 3), Sphere{}, projection, squashed).unexplained == 0);
    const Cylinder tube{{0, -0.5, 0}, {0, 0.5, 0}, 0.5};
    const AnalyticAgreement a = compare(shapes::cylinder(0.5f, 1.0f, 24), tube, projection, squashed);
    CHECK(a.unexplained == 0);
    CHECK(a.silhouette > 0);
    CHECK(a.inner_share == doctest::Approx(0.99144).epsilon(1e-4));  // cos(π/24)
  }
}

TEST_CASE("a body that is not the mesh's is found out") {
  const Mesh mesh = shapes::sphere(1.0f, 48, 24);
  CHECK_THROWS_AS(compare(mesh, Sphere{{0, 0, 0}, 1.05}, "perspective"), ContractViolation);
  CHECK_THROWS_AS(compare(mesh, Sphere{{0.05, 0, 0}, 1.0}, "perspective"), ContractViolation);
  CHECK(compare(mesh, Cylinder{{0, -1, 0}, {0, 1, 0}, 1.0}, "isometric").unexplained > 0);
}

TEST_CASE("objects before each other keep their ids") {
  Scene scene;
  const std::uint32_t mesh = scene.add_mesh(shapes::sphere(1.0f, 64, 32));
  std::vector<AnalyticBody> bodies;
  for (int i = 0; i < 5; ++i) {
    glm::dmat4 placement(0.4 + 0.1 * i);
    placement[3] = {0.9 * i, 0.2 * (i % 2), -1.5 * i, 1.0};
    scene.add_instance({mesh, 0, placement, ""});
    bodies.emplace_back(Sphere{});
  }
  RenderSettings settings;
  settings.width = settings.height = 160;
  const Camera camera = frame(scene.bounds(), parse_projection("perspective"), {});
  const AnalyticAgreement a = agree_analytic(scene, bodies, camera, settings);
  CHECK(a.covered > 1000);
  CHECK(a.unexplained == 0);
}
