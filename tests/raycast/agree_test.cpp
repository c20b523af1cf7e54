#include <doctest/doctest.h>

#include <string>
#include <velum/velum.hpp>

#include "random_rays.hpp"
#include "solids.hpp"

using namespace velum;

namespace {

/// The solids, and lines among them.
Scene solids_and_lines(const glm::dvec3& offset) {
  Scene scene = solids(offset);
  Mesh lines;
  lines.positions = {glm::vec3(-1, -1, -1), glm::vec3(1, 1, 1), glm::vec3(0.2f, 0.8f, 0.5f)};
  lines.segments = {glm::uvec2(0, 1)};
  lines.points = {2};
  scene.add(lines, moved(offset));
  return scene;
}

Mesh crossing_triangles(Random& random, int count) {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 centre = random_point(random);
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int k = 0; k < 3; ++k) positions.emplace_back(centre + random_point(random) * (i % 3 ? 0.2 : 1.0));
    triangles.emplace_back(first, first + 1, first + 2);
  }
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  return mesh;
}

RenderSettings settings_of(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  return settings;
}

Camera camera_of(const Scene& scene, std::string_view projection, const RenderSettings& settings) {
  FrameOptions options;
  options.aspect = static_cast<double>(settings.width) / settings.height;
  return frame(scene.bounds(), parse_projection(std::string(projection)), options);
}

/// Nothing unexplained, and the classes excuse few pixels.
void check(const AgreementReport& report) {
  CHECK(report.of(Agreement::unexplained) == 0);
  CHECK(report.covered > 100);
  CHECK(report.differing_share() < 0.03);
}

bool same_bytes(const Picture& a, const Picture& b) {
  for (int y = 0; y < a.colour.height(); ++y) {
    for (int x = 0; x < a.colour.width(); ++x) {
      if (a.triangle_id.at(x, y) != b.triangle_id.at(x, y) || a.depth.at(x, y) != b.depth.at(x, y) ||
          !(a.colour.at(x, y) == b.colour.at(x, y))) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE("raster and ray casting agree under every projection") {
  const Scene scene = solids_and_lines(glm::dvec3(0.0));
  const RenderSettings settings = settings_of(90, 70);
  for (const ProjectionEntry& entry : projection_catalogue()) {
    CAPTURE(entry.name);
    check(agree(scene, camera_of(scene, entry.name, settings), settings));
  }
}

TEST_CASE("raster and ray casting agree 10,000 units from the origin") {
  const Scene scene = solids_and_lines(glm::dvec3(1e4));
  const RenderSettings settings = settings_of(90, 70);
  for (const ProjectionEntry& entry : projection_catalogue()) {
    CAPTURE(entry.name);
    check(agree(scene, camera_of(scene, entry.name, settings), settings));
  }
}

TEST_CASE("raster and ray casting agree on every built-in shape") {
  const RenderSettings settings = settings_of(80, 60);
  for (const std::string_view name : builtin_names()) {
    const std::string named(name);
    CAPTURE(named);
    Scene scene;
    scene.add(builtin_shape(name));
    for (const char* projection : {"perspective", "isometric", "cavalier"}) {
      check(agree(scene, camera_of(scene, projection, settings), settings));
    }
  }
}

TEST_CASE("raster and ray casting agree for a viewer among triangles that cross each other") {
  Random random{51};
  for (int i = 0; i < 6; ++i) {
    Scene scene;
    scene.add(crossing_triangles(random, 120));
    scene.add(shapes::cube(3.0f));
    const Pose pose = Pose::towards(random_point(random, 0.5), random_point(random));
    const Camera camera = Camera::perspective(pose, {VerticalAngle{1.6}, {0.1, -0.2}}, 0.05, 2.0);
    RenderSettings settings = settings_of(80, 80);
    settings.cull = i % 3 == 0 ? Cull::none : (i % 3 == 1 ? Cull::back : Cull::front);
    check(agree(scene, camera, settings));
  }
}

TEST_CASE("raster and ray casting agree for embedders' matrices, an infinite far plane too") {
  const Scene scene = solids_and_lines({0.0, 0.0, -4.0});
  const RenderSettings settings = settings_of(80, 80);
  glm::dmat4 infinite(0.0);
  infinite[0][0] = infinite[1][1] = 2.0;
  infinite[2][2] = infinite[2][3] = -1.0;
  infinite[3][2] = -0.5;
  check(agree(scene, Camera::from_clip_matrix(infinite, DepthRange::zero_to_one), settings));
  glm::dmat4 reversed = infinite;
  for (int column = 0; column < 4; ++column) reversed[column][2] = infinite[column][3] - infinite[column][2];
  check(agree(scene, Camera::from_clip_matrix(reversed, DepthRange::one_to_zero), settings));
}

TEST_CASE("ray casting gives the same bytes with every structure, thread count, executor and crop") {
  const Scene scene = solids_and_lines(glm::dvec3(0.0));
  RenderSettings settings = settings_of(70, 50);
  settings.visibility = VisibilityMethod::raycast;
  settings.accelerator = AcceleratorKind::brute_force;
  settings.threads = 1;
  const Camera camera = camera_of(scene, "perspective", settings);
  const Picture oracle = render(scene, camera, settings);
  for (const AcceleratorName& name : accelerator_names()) {
    CAPTURE(name.name);
    settings.accelerator = name.kind;
    for (const int threads : {1, 3}) {
      settings.threads = threads;
      settings.executor = threads == 1 ? ExecutorKind::tbb : ExecutorKind::std_thread;
      const Picture picture = render(scene, camera, settings);
      CHECK(same_bytes(picture, oracle));
      CHECK(picture.counters.rays == 70 * 50);
      CHECK(picture.counters.ray_tests > 0);
      if (threads == 3)
        CHECK(picture.counters.ray_tests == render(scene, camera, settings).counters.ray_tests);
    }
  }
  settings.crop = Rect{11, 7, 33, 40};
  const Picture part = render(scene, camera, settings);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 33; ++x) {
      REQUIRE(part.triangle_id.at(x, y) == oracle.triangle_id.at(x + 11, y + 7));
      REQUIRE(part.depth.at(x, y) == oracle.depth.at(x + 11, y + 7));
    }
  }
}

TEST_CASE("where raster and ray casting see the same triangle, depth and colour have the same bits") {
  Scene scene = solids_and_lines(glm::dvec3(0.0));
  Material glass;
  glass.alpha = 0.5f;
  scene.set_material(0, glass);  // layers behind the first one too
  RenderSettings settings = settings_of(90, 70);
  for (const char* projection : {"perspective", "cabinet"}) {
    const Camera camera = camera_of(scene, projection, settings);
    settings.visibility = VisibilityMethod::zbuffer;
    const Picture raster = render(scene, camera, settings);
    settings.visibility = VisibilityMethod::raycast;
    const Picture rays = render(scene, camera, settings);
    int same = 0, same_colour = 0;
    for (int y = 0; y < 70; ++y) {
      for (int x = 0; x < 90; ++x) {
        if (raster.triangle_id.at(x, y) != rays.triangle_id.at(x, y)) continue;
        ++same;
        CHECK(raster.depth.at(x, y) == rays.depth.at(x, y));
        same_colour += raster.colour.at(x, y) == rays.colour.at(x, y);
      }
    }
    CHECK(same > 90 * 70 * 98 / 100);
    CHECK(same_colour == same);
  }
}

TEST_CASE("a renderer that casts rays notices that the scene has changed") {
  Scene scene = solids_and_lines(glm::dvec3(0.0));
  RenderSettings settings = settings_of(60, 60);
  settings.visibility = VisibilityMethod::raycast;
  const Camera camera = camera_of(scene, "perspective", settings);
  Renderer renderer;
  CHECK(same_bytes(renderer.render(scene, camera, settings), render(scene, camera, settings)));
  scene.set_world_from_object(0, moved({0.3, 0.0, 0.0}));
  CHECK(same_bytes(renderer.render(scene, camera, settings), render(scene, camera, settings)));
  settings.accelerator = AcceleratorKind::kd_tree;
  CHECK(same_bytes(renderer.render(scene, camera, settings), render(scene, camera, settings)));
  const Scene empty;
  CHECK(renderer.render(empty, camera, settings).coverage() == 0.0);
}

TEST_CASE("ray casting refuses depth formats, which are about a buffer") {
  RenderSettings settings = settings_of(10, 10);
  settings.visibility = VisibilityMethod::raycast;
  settings.depth_format = DepthFormat::z16;
  const Scene scene = solids_and_lines(glm::dvec3(0.0));
  CHECK_THROWS_AS(render(scene, camera_of(scene, "perspective", settings), settings), Error);
}

TEST_CASE("agreement catches planted faults") {
  Scene scene;
  Mesh mesh;  // its outline is long, so even a fault of a hundredth of a pixel meets some pixel centres
  mesh.positions = {glm::vec3(-0.9f, -0.83f, 0.1f), glm::vec3(0.87f, -0.71f, -0.2f),
                    glm::vec3(0.13f, 0.91f, 0.3f)};
  mesh.triangles = {glm::uvec3(0, 1, 2)};
  scene.add(mesh);
  const Pose pose = Pose::towards({0.1, 0.2, 3.0}, {0.0, 0.0, 0.0});
  const Camera camera = Camera::perspective(pose, {VerticalAngle{0.7}}, 1.0, 10.0);
  RenderSettings settings = settings_of(768, 768);
  settings.shading = Shading::triangle_id;
  const Picture raster = render(scene, camera, settings);
  settings.visibility = VisibilityMethod::raycast;
  Picture rays = render(scene, camera, settings);
  const auto unexplained = [&](const Picture& by_raster, const Picture& by_rays) {
    return compare_visibility(scene, camera, settings, by_raster.triangle_id, by_rays.triangle_id)
        .of(Agreement::unexplained);
  };
  CHECK(unexplained(raster, rays) == 0);

  SUBCASE("a vertex moved by 0.01 pixel") {
    Scene other;
    Mesh moved_mesh = mesh;
    const float step = static_cast<float>(-0.01 * 2.0 * 3.0 * 0.365 / settings.height);
    moved_mesh.positions = {mesh.positions[0] + glm::vec3(step, 0, 0), mesh.positions[1], mesh.positions[2]};
    other.add(moved_mesh);
    CHECK(unexplained(raster, render(other, camera, settings)) > 0);
  }
  SUBCASE("a pixel lost inside") {
    rays.triangle_id.at(384, 384) = no_primitive;
    CHECK(unexplained(raster, rays) == 1);
  }
  SUBCASE("a pixel too many outside") {
    rays.triangle_id.at(2, 2) = 0;
    CHECK(unexplained(raster, rays) == 1);
  }
}

TEST_CASE("agreement catches a surface that shines through from behind") {
  Scene scene;
  scene.add(shapes::cube(1.0f));
  scene.add(shapes::cube(0.99f));  // hidden inside, a hundredth behind the surface
  const RenderSettings settings = settings_of(100, 100);
  const Camera camera = camera_of(scene, "isometric", settings);
  const AgreementReport good = agree(scene, camera, settings);
  CHECK(good.is_explained());
  Scene inner_only;
  inner_only.add(shapes::cube(0.99f));
  RenderSettings ids = settings;
  ids.shading = Shading::triangle_id;
  Picture raster = render(scene, camera, ids);
  const Picture inner = render(inner_only, camera, ids);
  const std::uint32_t centre = inner.triangle_id.at(50, 40);
  REQUIRE(centre != no_primitive);
  raster.triangle_id.at(50, 40) = centre + 12;
  ids.visibility = VisibilityMethod::raycast;
  const Picture rays = render(scene, camera, ids);
  const AgreementReport bad =
      compare_visibility(scene, camera, settings, raster.triangle_id, rays.triangle_id);
  CHECK(bad.of(Agreement::unexplained) == 1);
}
