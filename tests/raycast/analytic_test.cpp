#include <doctest/doctest.h>

#include <glm/geometric.hpp>
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

namespace {

/// A squashed and mirrored sphere, from nearby.
struct Egg {
  Scene scene;
  RenderSettings settings;
  Camera camera;

  Egg() : camera(placed(scene)) {
    settings.width = 120;
    settings.height = 90;
  }
  Picture picture() const {
    return render_analytic(scene, std::array<AnalyticBody, 1>{Sphere{}}, camera, settings);
  }

 private:
  static Camera placed(Scene& scene) {
    glm::dmat4 squashed(1.0);
    squashed[0][0] = -2.0;
    squashed[1][1] = 0.6;
    squashed[1][0] = 0.3;
    scene.add(shapes::sphere(1.0f, 512, 256), squashed);
    return frame(scene.bounds(), parse_projection("perspective"), {.aspect = 120.0 / 90.0});
  }
};

/// Over the pixels that both show, the largest distance of depths and of normals.
std::pair<double, double> largest_differences(const Picture& a, const Picture& b) {
  double depth = 0.0, normal = 0.0;
  for (int y = 0; y < a.depth.height(); ++y) {
    for (int x = 0; x < a.depth.width(); ++x) {
      if (a.object_id.at(x, y) != 0 || b.object_id.at(x, y) != 0) continue;
      const auto difference = a.metric_depth.at(x, y) - b.metric_depth.at(x, y);
      const glm::vec3 turn = a.normal.at(x, y) - b.normal.at(x, y);
      depth = std::max(depth, std::abs(static_cast<double>(difference)));
      normal = std::max(normal, static_cast<double>(glm::length(turn)));
    }
  }
  return {depth, normal};
}

}  // namespace

TEST_CASE("a body rendered by its equation is what its triangles tend to") {
  for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
    Egg egg;
    egg.settings.cull = cull;
    const Picture body = egg.picture(), triangles = render(egg.scene, egg.camera, egg.settings);
    CHECK(body.coverage() > 0.15);
    CHECK(std::abs(body.coverage() - triangles.coverage()) < 0.002);
    const auto [depth, normal] = largest_differences(body, triangles);
    CHECK(depth < 0.03);  // near the outline the two lie apart along the ray
    CHECK(normal < 0.1);
    CHECK(compare(body.colour.view(), triangles.colour.view()).rmse < 4.0);
  }
}

TEST_CASE("bodies: the same bytes with any number of threads, and in a crop") {
  Egg egg;
  egg.settings.threads = 1;
  const Picture one = egg.picture();
  egg.settings.threads = 3;
  const Picture three = egg.picture();
  CHECK(compare(three.colour.view(), one.colour.view()).same_bytes);
  CHECK(compare(three.depth.view(), one.depth.view()).same_bytes);
  egg.settings.crop = Rect{31, 17, 40, 50};
  const Picture part = egg.picture();
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 40; ++x) {
      REQUIRE(part.colour.at(x, y) == one.colour.at(x + 31, y + 17));
      REQUIRE(part.depth.at(x, y) == one.depth.at(x + 31, y + 17));
    }
  }
}

TEST_CASE("what needs triangles is refused for bodies") {
  const auto refused = [](const auto& change) {
    Egg egg;
    change(egg.settings);
    CHECK_THROWS_AS(egg.picture(), Error);
  };
  refused([](RenderSettings& s) { s.shading = Shading::flat; });
  refused([](RenderSettings& s) { s.shading = Shading::barycentric; });
  refused([](RenderSettings& s) { s.wireframe = true; });
  refused([](RenderSettings& s) { s.samples = 4; });
  refused([](RenderSettings& s) { s.supersample = 2; });
}
