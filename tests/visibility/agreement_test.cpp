#include <doctest/doctest.h>

#include <string>
#include <velum/velum.hpp>

#include "classify.hpp"
#include "random.hpp"
#include "solids.hpp"

using namespace velum;
using oracle::Reason;

namespace {

/// Every name of the catalogue, with default parameters.
std::vector<std::string> projection_names() {
  std::vector<std::string> names;
  for (const ProjectionEntry& entry : projection_catalogue()) names.emplace_back(entry.name);
  return names;
}

/// Random triangles in the unit cube about the origin: large, small and needle-shaped ones, piercing each
/// other.
Mesh random_triangles(Random& random, int count) {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 centre(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double size = i % 3 == 0 ? 1.0 : (i % 3 == 1 ? 0.3 : 0.05);
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int k = 0; k < 3; ++k) {
      const double along = i % 4 == 3 && k == 2 ? 0.02 : 1.0;
      positions.emplace_back(
          centre +
          size * along * glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    }
    triangles.emplace_back(first, first + 1, first + 2);
  }
  Mesh mesh;
  mesh.name = "random triangles";
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  return mesh;
}

oracle::Comparison compare_render(const Scene& scene, const Camera& camera, int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  return oracle::compare(scene, camera, render(scene, camera, settings).triangle_id);
}

void check_agreement(const Scene& scene, const std::string& projection, int width, int height) {
  FrameOptions options;
  options.aspect = static_cast<double>(width) / height;
  const Camera camera = frame(scene.bounds(), parse_projection(projection), options);
  const oracle::Comparison result = compare_render(scene, camera, width, height);
  CAPTURE(projection);
  CHECK(result.of(Reason::unexplained) == 0);
  CHECK(result.of(Reason::same) > result.pixels * 95 / 100);  // the classes excuse few pixels
}

}  // namespace

TEST_CASE("z-buffer and ray oracle agree under every projection") {
  const Scene scene = solids(glm::dvec3(0.0));
  for (const std::string& name : projection_names()) check_agreement(scene, name, 80, 60);
}

TEST_CASE("z-buffer and ray oracle agree 10,000 units from the origin") {
  const Scene scene = solids(glm::dvec3(1e4));
  for (const std::string& name : projection_names()) check_agreement(scene, name, 80, 60);
}

TEST_CASE("z-buffer and ray oracle agree on random triangles that pierce each other") {
  Random random{11};
  Scene scene;
  scene.add(random_triangles(random, 150));
  for (const std::string& name : projection_names()) check_agreement(scene, name, 72, 72);
}

TEST_CASE("z-buffer and ray oracle agree for a viewer inside the scene, cut by the near plane") {
  Random random{12};
  for (int i = 0; i < 8; ++i) {
    Scene scene;
    scene.add(random_triangles(random, 100));
    scene.add(shapes::cube(3.0f));
    const glm::dvec3 eye(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    const Pose pose =
        Pose::towards(eye, {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    const Camera camera = Camera::perspective(pose, {VerticalAngle{1.6}, {0.1, -0.2}}, 0.05, 2.0);
    const oracle::Comparison result = compare_render(scene, camera, 64, 64);
    CHECK(result.of(Reason::unexplained) == 0);
    CHECK(result.of(Reason::same) > result.pixels * 95 / 100);
  }
}

TEST_CASE("the oracle catches planted faults") {
  // One large triangle: its outline is long, so even a fault of a hundredth of a pixel meets some pixel
  // centres.
  Scene scene;
  Mesh mesh;
  mesh.positions = {glm::vec3(-0.9f, -0.83f, 0.1f), glm::vec3(0.87f, -0.71f, -0.2f),
                    glm::vec3(0.13f, 0.91f, 0.3f)};
  mesh.triangles = {glm::uvec3(0, 1, 2)};
  scene.add(mesh);
  const Pose pose = Pose::towards({0.1, 0.2, 3.0}, {0.0, 0.0, 0.0});
  const Camera camera = Camera::perspective(pose, {VerticalAngle{0.7}}, 1.0, 10.0);
  constexpr int size = 1024;
  RenderSettings settings;
  settings.width = settings.height = size;
  CHECK(oracle::compare(scene, camera, render(scene, camera, settings).triangle_id).of(Reason::unexplained) ==
        0);

  SUBCASE("the raster shifted by 1/64 pixel") {
    glm::dmat4 shift(1.0);
    shift[3].x = 2.0 / size / 64.0;  // in x/w: a shear by w
    glm::dmat4 by_w(1.0);
    by_w[3][0] = 0.0;
    glm::dmat4 m = camera.viewing_transform(1.0).clip_from_world();
    for (int column = 0; column < 4; ++column) m[column][0] += shift[3].x * m[column][3];
    const Camera shifted = Camera::from_clip_matrix(m, DepthRange::zero_to_one);
    const Picture picture = render(scene, shifted, settings);
    CHECK(oracle::compare(scene, camera, picture.triangle_id).of(Reason::unexplained) > 0);
  }
  SUBCASE("a vertex moved by 0.01 pixel") {
    const double unit = 2.0 * 3.0 * 0.365 / size;  // about the size of a pixel at the triangle's distance
    Scene moved_scene;
    Mesh moved_mesh = mesh;
    moved_mesh.positions = {mesh.positions[0] + glm::vec3(static_cast<float>(-0.01 * unit), 0.0f, 0.0f),
                            mesh.positions[1], mesh.positions[2]};
    moved_scene.add(moved_mesh);
    const Picture picture = render(moved_scene, camera, settings);
    CHECK(oracle::compare(scene, camera, picture.triangle_id).of(Reason::unexplained) > 0);
  }
}

TEST_CASE("the oracle catches two swapped ids") {
  const Scene scene = solids(glm::dvec3(0.0));
  const Camera camera = frame(scene.bounds(), projection::cabinet());
  RenderSettings settings;
  settings.width = settings.height = 64;
  Picture picture = render(scene, camera, settings);
  const std::uint32_t first = picture.triangle_id.at(32, 32);
  std::uint32_t second = first;
  for (int x = 0; x < 64 && second == first; ++x) {
    if (picture.triangle_id.at(x, 32) != no_primitive) second = picture.triangle_id.at(x, 32);
  }
  REQUIRE(first != no_primitive);
  REQUIRE(second != first);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      std::uint32_t& id = picture.triangle_id.at(x, y);
      id = id == first ? second : (id == second ? first : id);
    }
  }
  CHECK(oracle::compare(scene, camera, picture.triangle_id).of(Reason::unexplained) > 0);
}
