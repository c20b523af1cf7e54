#include "scene/scene.hpp"

#include <doctest/doctest.h>

#include <glm/ext/matrix_transform.hpp>
#include <limits>
#include <set>
#include <vector>

#include "base/contract.hpp"
#include "expect_error.hpp"
#include "random.hpp"

using namespace velum;

namespace {

/// `count` times the same triangle over three vertices.
Mesh strip(std::size_t count, const std::string& name = "strip") {
  Mesh mesh;
  mesh.name = name;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = std::vector<glm::uvec3>(count, glm::uvec3(0, 1, 2));
  return mesh;
}

glm::dmat4 with_entry(glm::length_t column, glm::length_t row, double value) {
  glm::dmat4 matrix(1.0);
  matrix[column][row] = value;
  return matrix;
}

}  // namespace

TEST_CASE("a new scene has the default material, nothing to see and empty bounds") {
  const Scene scene;
  CHECK(scene.materials().size() == 1);
  CHECK(scene.primitive_count() == 0);
  CHECK(scene.bounds().is_empty());
}

TEST_CASE("primitive ids number the triangles instance after instance, past empty meshes") {
  Scene scene;
  Random random{2024};
  std::vector<std::uint32_t> meshes;
  const std::vector<std::size_t> sizes = {0, 3, 1, 17, 0, 5};
  for (const std::size_t size : sizes) meshes.push_back(scene.add_mesh(strip(size)));
  std::vector<PrimitivePlace> expected;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const std::size_t choice = i < 3 || i > 196 ? 0 : random.next() % meshes.size();
    CHECK(scene.add_instance({meshes[choice], 0, glm::dmat4(1.0), ""}) == i);
    CHECK(scene.first_primitive(i) == expected.size());
    for (std::uint32_t t = 0; t < sizes[choice]; ++t) expected.push_back({i, t});
  }
  REQUIRE(scene.primitive_count() == expected.size());
  for (std::uint32_t id = 0; id < expected.size(); ++id) {
    CHECK(scene.place(id) == expected[id]);
    CHECK(scene.primitive(expected[id]) == id);
  }
  CHECK_THROWS_AS(scene.place(scene.primitive_count()), ContractViolation);
  CHECK_THROWS_AS(scene.first_primitive(200), ContractViolation);
  CHECK_THROWS_AS(scene.primitive({0, 0}), ContractViolation);
}

TEST_CASE("an instance's triangles come first, then its segments, then its points") {
  velum::Mesh mesh;
  mesh.positions = {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)};
  mesh.triangles = {glm::uvec3(0, 1, 2), glm::uvec3(2, 1, 0)};
  mesh.segments = {glm::uvec2(0, 1)};
  mesh.points = {2u, 0u};
  velum::Scene scene;
  scene.add(mesh);
  scene.add(mesh);
  CHECK(scene.primitive_count() == 10);
  CHECK(scene.first_primitive(1) == 5);
  using velum::PrimitiveKind;
  CHECK(scene.place(6) == velum::PrimitivePlace{1, 1, PrimitiveKind::triangle});
  CHECK(scene.place(7) == velum::PrimitivePlace{1, 0, PrimitiveKind::segment});
  CHECK(scene.place(9) == velum::PrimitivePlace{1, 1, PrimitiveKind::point});
  for (std::uint32_t id = 0; id < 10; ++id) CHECK(scene.primitive(scene.place(id)) == id);
  CHECK_THROWS_AS(scene.primitive({0, 1, PrimitiveKind::segment}), velum::ContractViolation);

  velum::Scene other;
  other.add(mesh);
  mesh.segments = {glm::uvec2(0, 2)};
  velum::Scene another;
  another.add(mesh);
  CHECK(other.revision() != another.revision());
  mesh.points = {3u};
  CHECK_THROWS_AS(other.add(mesh), velum::Error);
  mesh.points = {};
  mesh.segments = {glm::uvec2(0, 3)};
  CHECK_THROWS_AS(other.add(mesh), velum::Error);
}

TEST_CASE("more than 2^32-1 primitives is an error, and exactly so many are not") {
  Scene scene;
  const std::uint32_t million = scene.add_mesh(strip(1000000));
  for (int i = 0; i < 4294; ++i) scene.add_instance({million, 0, glm::dmat4(1.0), "many"});
  CHECK(scene.primitive_count() == 4294000000u);
  CHECK(scene.place(4293999999u) == PrimitivePlace{4293, 999999});
  const std::uint64_t revision = scene.revision();
  expect_error(ErrorKind::limit, {"many", "4294000000 + 1000000", "4294967295"}, [&] {
    scene.add_instance({million, 0, glm::dmat4(1.0), "many"});
  });
  expect_error(ErrorKind::limit, {"967296"}, [&] { scene.add(strip(967296)); });
  CHECK(scene.revision() == revision);
  CHECK(scene.meshes().size() == 1);
  scene.add(strip(967295));
  CHECK(scene.primitive_count() == 0xFFFFFFFFu);
  CHECK(scene.place(0xFFFFFFFEu) == PrimitivePlace{4294, 967294});
  CHECK_THROWS_AS(scene.add(strip(1)), Error);
}

TEST_CASE("a mesh that views the caller's arrays is not copied") {
  const std::vector<glm::vec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<glm::uvec3> triangles = {{0, 1, 2}};
  Mesh mesh;
  mesh.positions = Array<glm::vec3>::viewing(positions);
  mesh.triangles = Array<glm::uvec3>::viewing(triangles);
  Scene scene;
  scene.add(mesh);
  const Scene copy = scene;
  CHECK(copy.meshes()[0].positions.data() == positions.data());
  CHECK(copy.meshes()[0].triangles.data() == triangles.data());
}

TEST_CASE("unknown meshes, materials and instances are named") {
  Scene scene;
  const std::uint32_t mesh = scene.add_mesh(strip(1));
  expect_error(ErrorKind::usage, {"chair", "mesh 5", "has 1"}, [&] {
    scene.add_instance({5, 0, glm::dmat4(1.0), "chair"});
  });
  expect_error(ErrorKind::usage, {"chair", "material 3", "has 1"}, [&] {
    scene.add_instance({mesh, 3, glm::dmat4(1.0), "chair"});
  });
  expect_error(ErrorKind::usage, {"material 9"}, [&] { scene.add(strip(1), glm::dmat4(1.0), 9); });
  expect_error(ErrorKind::usage, {"material 1"}, [&] { scene.set_material(1, {}); });
  expect_error(ErrorKind::usage, {"instance 0"}, [&] { scene.set_world_from_object(0, glm::dmat4(1.0)); });
  Mesh broken = strip(1, "broken");
  broken.triangles = {{0, 1, 3}};
  expect_error(ErrorKind::usage, {"broken", "triangles[0]"}, [&] { scene.add_mesh(broken); });
  CHECK(scene.meshes().size() == 1);
  CHECK(scene.instances().empty());
}

TEST_CASE("matrices that cannot place a mesh are refused") {
  Scene scene;
  const std::uint32_t index = scene.add(strip(1, "brick"));
  const auto refused = [&](const glm::dmat4& matrix, const std::string& reason) {
    expect_error(ErrorKind::usage, {"brick", reason}, [&] { scene.set_world_from_object(index, matrix); });
    expect_error(ErrorKind::usage, {"brick", reason}, [&] { scene.add(strip(1, "brick"), matrix); });
  };
  refused(with_entry(1, 2, std::numeric_limits<double>::quiet_NaN()), "row 2, column 1");
  refused(with_entry(3, 0, std::numeric_limits<double>::infinity()), "not finite");
  refused(with_entry(0, 3, 0.01), "not affine");
  refused(with_entry(3, 3, 2.0), "not affine");
  refused(with_entry(1, 1, 0.0), "singular");
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(1, 2, 3));
  refused(turned * glm::scale(glm::dmat4(1.0), glm::dvec3(1, 0, 1)) * turned, "singular");
  CHECK(scene.meshes().size() == 1);
  CHECK(scene.instances()[index].world_from_object == glm::dmat4(1.0));
}

TEST_CASE("mirrored, tiny and huge instances are welcome") {
  Scene scene;
  const std::uint32_t mesh = scene.add_mesh(strip(1));
  const glm::dmat4 one(1.0);
  const glm::dmat4 turned = glm::rotate(one, 0.7, glm::dvec3(1, 2, 3));
  for (const glm::dvec3 scale :
       {glm::dvec3(-1, 1, 1), glm::dvec3(1e-150), glm::dvec3(1e150), glm::dvec3(1e-9, 1, 1e9)}) {
    CHECK_NOTHROW(scene.add_instance({mesh, 0, glm::scale(one, scale), ""}));
    CHECK_NOTHROW(scene.add_instance({mesh, 0, turned * glm::scale(one, scale), ""}));
  }
}

TEST_CASE("bounds are tight around the transformed vertices, not around transformed boxes") {
  Mesh diamond;
  diamond.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  diamond.triangles = {{0, 2, 1}, {0, 1, 3}};
  Scene scene;
  const glm::dmat4 matrix = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(10, 0, 0)),
                                        0.25 * 3.14159265358979323846, glm::dvec3(0, 0, 1));
  scene.add(diamond, matrix);
  CHECK(scene.bounds().upper.x == doctest::Approx(10 + 0.70710678118654752));  // the box's would be 11.41
  CHECK(scene.bounds().lower.y == doctest::Approx(-0.70710678118654752));
  CHECK(scene.bounds().size().z == 0.0);
}

TEST_CASE("bounds equal a loop over all vertices for every kind of matrix") {
  Random random{99};
  for (int round = 0; round < 40; ++round) {
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 20; ++i) {
      positions.emplace_back(random.uniform(-1, 1), random.uniform(-2, 1), random.uniform(3, 4));
    }
    glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(random.uniform(-5, 5), 1, 2));
    if (round % 2 == 1) matrix = glm::rotate(matrix, random.uniform(0, 6), glm::dvec3(1, -1, 0.5));
    matrix = glm::scale(matrix, glm::dvec3(random.uniform(-2, -1), random.uniform(1, 2), 1));
    if (round % 4 == 2) std::swap(matrix[0], matrix[2]);
    Aabb expected;
    for (const glm::vec3& p : positions) expected.include(glm::dvec3(matrix * glm::dvec4(p, 1.0f)));
    Mesh mesh;
    mesh.positions = positions;
    Scene scene;
    scene.add(mesh, matrix);
    const Aabb box = scene.bounds();
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      CHECK(box.lower[axis] == doctest::Approx(expected.lower[axis]).epsilon(1e-14));
      CHECK(box.upper[axis] == doctest::Approx(expected.upper[axis]).epsilon(1e-14));
    }
  }
}

TEST_CASE("bounds leave out vertices that are not finite") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Mesh mesh = strip(1);
  mesh.positions = {{0, 0, 0}, {1, nan, 0}, {0, 1, std::numeric_limits<float>::infinity()}, {2, 3, 4}};
  for (const double angle : {0.0, 0.3}) {
    Scene scene;
    scene.add(mesh, glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(0, 1, 0)));
    CHECK(scene.bounds().lower.y == 0.0);
    CHECK(scene.bounds().upper.y == 3.0);
  }
  mesh.positions = {{nan, 0, 0}, {nan, 0, 0}, {nan, 0, 0}};
  Scene scene;
  scene.add(mesh);
  CHECK(scene.bounds().is_empty());
}

TEST_CASE("every change of geometry or materials gives a new revision") {
  Scene scene;
  std::set<std::uint64_t> seen = {scene.revision()};
  const auto fresh = [&] { return seen.insert(scene.revision()).second; };
  scene.add_mesh(strip(2));
  CHECK(fresh());
  scene.add_mesh(strip(2));
  CHECK(fresh());
  scene.add_mesh({});
  CHECK(fresh());
  scene.add_material({});
  CHECK(fresh());
  scene.add_instance({0, 0, glm::dmat4(1.0), ""});
  CHECK(fresh());
  scene.add_instance({1, 1, glm::dmat4(1.0), ""});
  CHECK(fresh());
  scene.set_world_from_object(0, glm::dmat4(1.0));
  CHECK(fresh());
  scene.set_world_from_object(1, glm::dmat4(1.0));
  CHECK(fresh());
  scene.set_material(0, {});
  CHECK(fresh());
  scene.up = UpAxis::z;
  scene.point_lights.push_back({});
  CHECK_FALSE(fresh());
}

TEST_CASE("revisions tell scenes apart, and equal scenes are equal") {
  Scene first;
  first.add(strip(3));
  Scene copy = first;
  CHECK(copy.revision() == first.revision());
  first.set_world_from_object(0, with_entry(3, 0, 1.0));
  copy.set_world_from_object(0, with_entry(3, 0, 2.0));
  CHECK(copy.revision() != first.revision());
  Scene other;
  Mesh moved = strip(3);
  moved.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1.0000001f, 0}};
  other.add(moved);
  other.set_world_from_object(0, with_entry(3, 0, 1.0));
  CHECK(other.revision() != first.revision());
  Material red;
  red.base_colour = {1, 0, 0};
  Material glossy = red;
  glossy.shininess = 33;
  Scene a, b;
  a.set_material(0, red);
  b.set_material(0, glossy);
  CHECK(a.revision() != b.revision());
}
