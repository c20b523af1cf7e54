#include "scene/mesh.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "expect_error.hpp"
#include "random.hpp"

using namespace velum;

namespace {

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
constexpr float k_infinity = std::numeric_limits<float>::infinity();

Mesh triangle_mesh() {
  Mesh mesh;
  mesh.name = "flag";
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// Random vertices with random triangles between them.
Mesh random_mesh(std::uint64_t seed) {
  Random random{seed};
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  for (int i = 0; i < 40; ++i) positions.emplace_back(random.uniform(), random.uniform(), random.uniform());
  const auto vertex = [&] { return static_cast<std::uint32_t>(random.next() % positions.size()); };
  for (int i = 0; i < 90; ++i) {
    const std::uint32_t a = vertex(), b = vertex(), c = vertex();
    triangles.emplace_back(a, b, c);
  }
  Mesh mesh;
  mesh.positions = positions;
  mesh.triangles = triangles;
  return mesh;
}

/// Heron's area times the unit normal, in long double: another way to the same weight than the cross product.
std::array<long double, 3> heron_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const long double u = glm::length(b - a), v = glm::length(c - b), w = glm::length(a - c);
  const long double s = (u + v + w) / 2;
  const long double area = std::sqrt(std::max(0.0L, s * (s - u) * (s - v) * (s - w)));
  const glm::dvec3 cross = glm::cross(c - b, a - b);
  const double length = glm::length(cross);
  if (length == 0.0) return {};
  return {area * cross.x / length, area * cross.y / length, area * cross.z / length};
}

}  // namespace

TEST_CASE("mesh bounds hold all finite positions and no others") {
  Mesh mesh;
  CHECK(bounds(mesh).is_empty());
  mesh.positions = {{1, 2, 3}, {k_nan, 9, 9}, {-1, 5, 0}, {k_infinity, 0, 0}, {0, -k_infinity, 0}};
  CHECK(bounds(mesh).lower == glm::dvec3(-1, 2, 0));
  CHECK(bounds(mesh).upper == glm::dvec3(1, 5, 3));
  mesh.positions = {{k_nan, 0, 0}};
  CHECK(bounds(mesh).is_empty());
}

TEST_CASE("validate names the mesh, the array and the first offending index") {
  Mesh mesh = triangle_mesh();
  CHECK_NOTHROW(validate(mesh));
  CHECK_NOTHROW(validate(Mesh{}));
  mesh.triangles = {{0, 1, 2}, {0, 3, 7}, {9, 9, 9}};
  expect_error(ErrorKind::usage, {"flag", "triangles[1]", "vertex 3", "3 positions"},
               [&] { validate(mesh); });

  mesh = triangle_mesh();
  mesh.normals = {{0, 0, 1}};
  expect_error(ErrorKind::usage, {"flag", "normals", "1 elements for 3"}, [&] { validate(mesh); });
  mesh = triangle_mesh();
  mesh.texture_coordinates = {{0, 0}, {0, 1}};
  expect_error(ErrorKind::usage, {"texture_coordinates"}, [&] { validate(mesh); });
  mesh = triangle_mesh();
  mesh.colours = Array<glm::vec4>(std::vector<glm::vec4>(4));
  expect_error(ErrorKind::usage, {"colours"}, [&] { validate(mesh); });
}

TEST_CASE("smooth normals are the area-weighted means of the face normals") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Mesh mesh = random_mesh(seed);
    const std::vector<glm::vec3> normals = smooth_normals(mesh);
    REQUIRE(normals.size() == mesh.positions.size());
    std::vector<std::array<long double, 3>> sums(normals.size());
    for (const glm::uvec3& t : mesh.triangles) {
      const auto n = heron_normal(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]);
      for (const std::uint32_t vertex : {t.x, t.y, t.z}) {
        for (std::size_t axis = 0; axis < 3; ++axis) sums[vertex][axis] += n[axis];
      }
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const glm::dvec3 expected(sums[i][0], sums[i][1], sums[i][2]);
      if (glm::length(expected) < 1e-3) continue;
      CHECK(glm::length(glm::dvec3(normals[i]) - glm::normalize(expected)) < 1e-5);
    }
  }
}

TEST_CASE("a larger face bends a smooth normal more") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};  // area 1/2 towards +z, 3/2 towards +x
  const std::vector<glm::vec3> normals = smooth_normals(mesh);
  CHECK(glm::length(normals[0] - glm::normalize(glm::vec3(3, 0, 1))) < 1e-6f);
  CHECK(normals[1] == glm::vec3(0, 0, 1));
  CHECK(normals[3] == glm::vec3(1, 0, 0));
}

TEST_CASE("vertices without area get the normal (0, 0, 1)") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}, {k_nan, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 5, 4}};
  for (const glm::vec3& normal : smooth_normals(mesh)) CHECK(normal == glm::vec3(0, 0, 1));
  for (const glm::vec3& normal : with_flat_normals(mesh).normals) CHECK(normal == glm::vec3(0, 0, 1));
  mesh.triangles = {{0, 1, 6}};
  CHECK_THROWS_AS(smooth_normals(mesh), Error);
  CHECK_THROWS_AS(with_flat_normals(mesh), Error);
}

TEST_CASE("smooth normals survive the smallest and largest floats") {
  for (const float scale : {1e-40f, 1e-30f, 1e30f, 1e38f}) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, scale, 0}, {0, 0, scale}};
    mesh.triangles = {{0, 1, 2}};
    CHECK(smooth_normals(mesh)[0] == glm::vec3(1, 0, 0));
  }
}

TEST_CASE("flat normals give every triangle its own vertices and its face's normal") {
  Mesh mesh = random_mesh(7);
  mesh.name = "crumpled";
  std::vector<glm::vec2> uv;
  std::vector<glm::vec4> colours;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    uv.emplace_back(static_cast<float>(i), 0.5f);
    colours.emplace_back(0.0f, static_cast<float>(i), 0.0f, 1.0f);
  }
  mesh.texture_coordinates = uv;
  mesh.colours = colours;
  const Mesh flat = with_flat_normals(mesh);
  CHECK_NOTHROW(validate(flat));
  CHECK(flat.name == "crumpled");
  REQUIRE(flat.triangles.size() == mesh.triangles.size());
  REQUIRE(flat.positions.size() == 3 * mesh.triangles.size());
  for (std::uint32_t i = 0; i < flat.triangles.size(); ++i) {
    CHECK(flat.triangles[i] == glm::uvec3(3 * i, 3 * i + 1, 3 * i + 2));
    const glm::uvec3 old = mesh.triangles[i];
    const glm::dvec3 a(mesh.positions[old.x]), b(mesh.positions[old.y]), c(mesh.positions[old.z]);
    const glm::dvec3 cross = glm::cross(c - b, a - b);
    for (glm::length_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = flat.triangles[i][corner];
      CHECK(flat.positions[vertex] == mesh.positions[old[corner]]);
      CHECK(flat.texture_coordinates[vertex] == uv[old[corner]]);
      CHECK(flat.colours[vertex] == colours[old[corner]]);
      if (glm::length(cross) < 1e-6) continue;
      CHECK(glm::length(glm::dvec3(flat.normals[vertex]) - glm::normalize(cross)) < 1e-6);
    }
  }
}

TEST_CASE("an array that views the caller's elements shares their memory") {
  const std::vector<glm::vec3> mine = {{1, 2, 3}, {4, 5, 6}};
  const auto view = Array<glm::vec3>::viewing(mine);
  const Array<glm::vec3> copy = view;
  CHECK(copy.data() == mine.data());
  CHECK(copy.size() == 2);
  CHECK_FALSE(copy.is_owner());
  const Array<glm::vec3> owner(mine);
  const Array<glm::vec3> second = owner;
  CHECK(owner.is_owner());
  CHECK(owner.data() != mine.data());
  CHECK(second.data() == owner.data());
}
