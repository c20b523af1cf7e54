#include "scene/builtin.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/elementary.hpp"
#include "expect_error.hpp"
#include "topology.hpp"

using namespace velum;

namespace {

struct Named {
  std::string what;
  Mesh mesh;
};

/// All closed shapes: as they are by default, and with odd, least and many parameters.
std::vector<Named> closed_shapes() {
  std::vector<Named> all;
  for (const std::string_view name : builtin_names()) {
    if (name != "grid") all.push_back({std::string(name), builtin_shape(name)});
  }
  for (const int n : {3, 4, 5, 7, 10, 33, 100}) {
    const std::string suffix = " " + std::to_string(n);
    all.push_back({"sphere" + suffix, shapes::sphere(0.3f, n, std::max(2, n / 2))});
    all.push_back({"cylinder" + suffix, shapes::cylinder(0.7f, 0.1f, n)});
    all.push_back({"cone" + suffix, shapes::cone(0.1f, 3.3f, n)});
    all.push_back({"torus" + suffix, shapes::torus(1.1f, 0.3f, n, 103 - n)});
    all.push_back({"stairs" + suffix, shapes::stairs(n, 0.7f, 0.17f, 0.29f)});
  }
  for (int i = 0; i < 5; ++i) all.push_back({"icosphere " + std::to_string(i), shapes::icosphere(0.7f, i)});
  all.push_back({"stairs 1", shapes::stairs(1)});
  all.push_back({"cube 0.1", shapes::cube(0.1f)});
  all.push_back({"dodecahedron 1e-15", shapes::dodecahedron(1e-15f)});
  all.push_back({"torus 1e15", shapes::torus(1e15f, 0.99e15f, 12, 13)});
  return all;
}

std::vector<Named> all_shapes() {
  std::vector<Named> all = closed_shapes();
  all.push_back({"grid", shapes::grid()});
  return all;
}

glm::dvec3 face_normal(const Mesh& mesh, const glm::uvec3& t) {
  const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
  return glm::cross(b - a, c - a);
}

}  // namespace

TEST_CASE("the built-in shapes carry the names of the command line") {
  const std::vector<std::string_view> expected = {
      "tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron", "box",   "sphere",  "icosphere",
      "cylinder",    "cone", "torus",      "grid",         "stairs",      "house", "letter-f"};
  CHECK(builtin_names() == expected);
  for (const std::string_view name : expected) CHECK(builtin_shape(name).name == name);
  expect_error(ErrorKind::usage, {"builtin:teapot", "no such", "cube, octahedron", "letter-f"},
               [] { builtin_shape("teapot"); });
}

TEST_CASE("closed shapes have every edge twice, in opposite directions") {
  for (const Named& shape : closed_shapes()) {
    CAPTURE(shape.what);
    const Mesh& mesh = shape.mesh;
    CHECK(is_closed(weld(mesh)));
  }
}

TEST_CASE("the Euler characteristic is 2 for a ball, 0 for a torus, 2 for each part of the house") {
  for (const Named& shape : closed_shapes()) {
    CAPTURE(shape.what);
    const Mesh& mesh = shape.mesh;
    const std::int64_t expected = mesh.name == "torus" ? 0 : mesh.name == "house" ? 18 : 2;
    CHECK(euler_characteristic(weld(mesh)) == expected);
  }
}

TEST_CASE("triangles face outwards: every closed part has a positive volume") {
  for (const Named& shape : closed_shapes()) {
    CAPTURE(shape.what);
    const Mesh& mesh = shape.mesh;
    const std::vector<double> parts = volumes(weld(mesh));
    CHECK(parts.size() == (mesh.name == "house" ? 9 : 1));
    for (const double part : parts) CHECK(part > 0.0);
  }
}

TEST_CASE("normals have length one and look to their triangles' front side") {
  for (const Named& shape : all_shapes()) {
    CAPTURE(shape.what);
    const Mesh& mesh = shape.mesh;
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    double worst = 0.0;
    for (const glm::vec3& n : mesh.normals) {
      worst = std::max(worst, std::abs(glm::length(glm::dvec3(n)) - 1.0));
    }
    CHECK(worst < 1e-6);
    bool agree = true;
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec3 normal = face_normal(mesh, t);
      for (glm::length_t i = 0; i < 3; ++i) {
        agree = agree && glm::dot(normal, glm::dvec3(mesh.normals[t[i]])) > 0.0;
      }
    }
    CHECK(agree);
  }
}

TEST_CASE("flat-faced solids have their faces' normals") {
  for (const std::string_view name : {"tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron",
                                      "box", "stairs", "house", "letter-f", "grid"}) {
    CAPTURE(name);
    const Mesh mesh = builtin_shape(name);
    double worst = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec3 normal = glm::normalize(face_normal(mesh, t));
      for (glm::length_t i = 0; i < 3; ++i) {
        worst = std::max(worst, glm::length(normal - glm::dvec3(mesh.normals[t[i]])));
      }
    }
    CHECK(worst < 2e-6);
  }
}

TEST_CASE("round shapes have the normals of the true surface") {
  const Mesh sphere = shapes::sphere(2.0f, 20, 10);
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
    CHECK(glm::length(sphere.positions[i] / 2.0f - sphere.normals[i]) < 1e-6f);
  }
  const Mesh icosphere = shapes::icosphere(2.0f, 2);
  for (std::size_t i = 0; i < icosphere.positions.size(); ++i) {
    CHECK(glm::length(icosphere.positions[i] / 2.0f - icosphere.normals[i]) < 1e-6f);
  }
  const Mesh torus = shapes::torus(1.0f, 0.25f, 24, 12);
  for (std::size_t i = 0; i < torus.positions.size(); ++i) {
    const glm::vec3 p = torus.positions[i];
    const glm::vec3 spine = glm::normalize(glm::vec3(p.x, 0.0f, p.z));
    CHECK(glm::length((p - spine) / 0.25f - torus.normals[i]) < 1e-5f);
  }
  const Mesh cone = shapes::cone(0.5f, 2.0f, 16);
  for (std::size_t i = 0; i < cone.positions.size(); ++i) {
    if (cone.normals[i].y < 0.0f) continue;  // the base
    // The slope: radius over height, and no part along the surface line towards the apex.
    CHECK(cone.normals[i].y == doctest::Approx(0.5 / std::sqrt(0.25 + 4.0)));
    if (cone.positions[i].y > 0.0f) continue;
    CHECK(std::abs(glm::dot(glm::vec3(0, 1, 0) - cone.positions[i], cone.normals[i])) < 1e-6f);
  }
}

TEST_CASE("volumes are the analytic ones") {
  const double root5 = std::sqrt(5.0);
  const double dodecahedron_edge = 4.0 / (std::sqrt(3.0) * (1.0 + root5));
  const double icosahedron_edge = 4.0 / std::sqrt(10.0 + 2.0 * root5);
  CHECK(volume(shapes::cube()) == 1.0);
  CHECK(volume(shapes::cube(2.0f)) == 8.0);
  CHECK(volume(shapes::box()) == 0.375);
  CHECK(volume(shapes::tetrahedron()) == doctest::Approx(8.0 * std::sqrt(3.0) / 27.0).epsilon(1e-6));
  CHECK(volume(shapes::octahedron(0.5f)) == doctest::Approx(4.0 / 3.0 / 8.0).epsilon(1e-6));
  CHECK(volume(shapes::dodecahedron()) ==
        doctest::Approx((15.0 + 7.0 * root5) / 4.0 * std::pow(dodecahedron_edge, 3.0)).epsilon(1e-6));
  CHECK(volume(shapes::icosahedron()) ==
        doctest::Approx(5.0 * (3.0 + root5) / 12.0 * std::pow(icosahedron_edge, 3.0)).epsilon(1e-6));
  CHECK(volume(shapes::stairs(4, 1.5f, 0.25f, 0.5f)) ==
        doctest::Approx(1.5 * 0.25 * 0.5 * 10.0).epsilon(1e-6));
  CHECK(volume(shapes::letter_f()) == 0.25 * 0.1875 * (1.0 + 0.4375 + 0.3125));
  const double house = 1.4 * 0.8 + 1.24 * 0.07 * 1.64 + 0.16 * 0.63 * 0.18 + 0.22 * 0.39 * 0.065 +
                       0.18 * 0.16 * 0.065 + 4.0 * 0.22 * 0.24 * 0.065;
  CHECK(volume(shapes::house()) == doctest::Approx(house).epsilon(1e-6));
  for (const int n : {3, 8, 50}) {
    const double polygon = 0.5 * n * std::sin(2.0 * pi / n);
    CHECK(volume(shapes::cylinder(2.0f, 0.5f, n)) == doctest::Approx(polygon * 4.0 * 0.5).epsilon(1e-6));
    CHECK(volume(shapes::cone(2.0f, 0.5f, n)) == doctest::Approx(polygon * 4.0 * 0.5 / 3.0).epsilon(1e-6));
  }
}

TEST_CASE("round volumes converge from below, with the square of the step") {
  const auto converges = [](double limit, double coarse, double middle, double fine) {
    CHECK(coarse < middle);
    CHECK(middle < fine);
    CHECK(fine < limit);
    CHECK((limit - middle) / (limit - fine) == doctest::Approx(4.0).epsilon(0.05));
  };
  const auto sphere = [](int n) { return volume(shapes::sphere(1.0f, 2 * n, n)); };
  converges(4.0 / 3.0 * pi, sphere(8), sphere(16), sphere(32));
  const auto icosphere = [](int n) { return volume(shapes::icosphere(1.0f, n)); };
  converges(4.0 / 3.0 * pi, icosphere(2), icosphere(3), icosphere(4));
  const auto torus = [](int n) { return volume(shapes::torus(1.0f, 0.25f, 2 * n, n)); };
  converges(2.0 * pi * pi / 16.0, torus(8), torus(16), torus(32));
}

TEST_CASE("vertices of round shapes and polyhedra lie on their surface") {
  for (const std::string_view name :
       {"tetrahedron", "octahedron", "dodecahedron", "icosahedron", "sphere", "icosphere"}) {
    CAPTURE(name);
    for (const glm::vec3& p : builtin_shape(name).positions) {
      CHECK(glm::length(glm::dvec3(p)) == doctest::Approx(1.0).epsilon(1e-6));
    }
  }
}

TEST_CASE("the numbers of triangles are as expected") {
  const auto count = [](const Mesh& mesh) { return mesh.triangles.size(); };
  CHECK(count(shapes::tetrahedron()) == 4);
  CHECK(count(shapes::cube()) == 12);
  CHECK(shapes::cube().positions.size() == 24);
  CHECK(count(shapes::octahedron()) == 8);
  CHECK(count(shapes::dodecahedron()) == 36);
  CHECK(count(shapes::icosahedron()) == 20);
  CHECK(count(shapes::sphere(1.0f, 8, 4)) == 48);
  CHECK(count(shapes::icosphere(1.0f, 3)) == 1280);
  CHECK(count(shapes::cylinder(1.0f, 1.0f, 6)) == 24);
  CHECK(count(shapes::cone(1.0f, 1.0f, 6)) == 12);
  CHECK(count(shapes::torus(1.0f, 0.5f, 6, 5)) == 60);
  CHECK(count(shapes::grid(1.0f, 7)) == 98);
  CHECK(count(shapes::letter_f()) == 36);
}

TEST_CASE("bounds are centred and of the size asked for, exactly") {
  for (const std::string_view name : builtin_names()) {
    CAPTURE(name);
    const Aabb box = bounds(builtin_shape(name));
    CHECK(box.lower.x == -box.upper.x);
    CHECK(box.lower.z == -box.upper.z);
    CHECK(box.lower.y == (name == "house" ? 0.0 : -box.upper.y));
  }
  CHECK(bounds(shapes::cube()).size() == glm::dvec3(1.0));
  CHECK(bounds(shapes::box(0.1f, 2.0f, 3.0f)).upper == glm::dvec3(0.05f, 1.0f, 1.5f));
  CHECK(bounds(shapes::sphere(3.0f)).size() == glm::dvec3(6.0));
  CHECK(bounds(shapes::cylinder(0.5f, 3.0f)).size() == glm::dvec3(1.0, 3.0, 1.0));
  CHECK(bounds(shapes::torus()).size() == glm::dvec3(2.0, 0.5, 2.0));
  CHECK(bounds(shapes::grid(3.0f, 7)).size() == glm::dvec3(3.0, 0.0, 3.0));
  CHECK(bounds(shapes::letter_f()).size() == glm::dvec3(0.625, 1.0, 0.25));
}

TEST_CASE("the grid is open, faces up, and its boundary is its rim") {
  const int cells = 6;
  const Mesh grid = shapes::grid(2.0f, cells);
  const Welded welded = weld(grid);
  const EdgeCounts edges = directed_edges(welded);
  int boundary = 0;
  for (const auto& [edge, count] : edges) {
    CHECK(count == 1);
    if (edges.count({edge.second, edge.first}) == 1) continue;
    ++boundary;
    const glm::dvec3 middle = 0.5 * (welded.positions[edge.first] + welded.positions[edge.second]);
    CHECK(std::max(std::abs(middle.x), std::abs(middle.z)) == 1.0);
  }
  CHECK(boundary == 4 * cells);
  for (const glm::vec3& normal : grid.normals) CHECK(normal == glm::vec3(0, 1, 0));
  for (const glm::uvec3& t : grid.triangles) CHECK(face_normal(grid, t).y > 0.0);
}

TEST_CASE("textures are never mirrored, and lie in the unit square but for the icosphere's seam") {
  for (const Named& shape : all_shapes()) {
    CAPTURE(shape.what);
    const Mesh& mesh = shape.mesh;
    REQUIRE(mesh.texture_coordinates.size() == mesh.positions.size());
    double least = 1.0;
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::dvec2 a(mesh.texture_coordinates[t.x]);
      const glm::dvec2 ab = glm::dvec2(mesh.texture_coordinates[t.y]) - a;
      const glm::dvec2 ac = glm::dvec2(mesh.texture_coordinates[t.z]) - a;
      least = std::min(least, ab.x * ac.y - ab.y * ac.x);
    }
    CHECK(least > 0.0);
    const float widest = mesh.name == "icosphere" ? 1.5f : 1.0f;
    for (const glm::vec2& uv : mesh.texture_coordinates) {
      const bool is_inside = uv.x >= 0.0f && uv.x <= widest && uv.y >= 0.0f && uv.y <= 1.0f;
      if (!is_inside) FAIL_CHECK("outside: ", uv.x, ", ", uv.y);
    }
  }
}

TEST_CASE("no position and no normal has a negative zero, so equal ones have equal bits") {
  for (const Named& shape : all_shapes()) {
    CAPTURE(shape.what);
    const Mesh& mesh = shape.mesh;
    int negative_zeros = 0;
    for (const auto* array : {&mesh.positions, &mesh.normals}) {
      for (const glm::vec3& v : *array) {
        for (glm::length_t i = 0; i < 3; ++i) negative_zeros += v[i] == 0.0f && std::signbit(v[i]) ? 1 : 0;
      }
    }
    CHECK(negative_zeros == 0);
  }
}

TEST_CASE("every vertex is used") {
  for (const Named& shape : all_shapes()) {
    CAPTURE(shape.what);
    const Mesh& mesh = shape.mesh;
    std::vector<bool> used(mesh.positions.size());
    for (const glm::uvec3& t : mesh.triangles) used[t.x] = used[t.y] = used[t.z] = true;
    CHECK(std::find(used.begin(), used.end(), false) == used.end());
  }
}

TEST_CASE("the letter F equals none of its mirror images, and reads from the front") {
  const Mesh f = shapes::letter_f();
  REQUIRE(f.colours.size() == f.positions.size());
  using Key = std::tuple<float, float, float, float>;
  const auto keys = [&](glm::vec3 sign) {
    std::set<Key> result;
    for (std::size_t i = 0; i < f.positions.size(); ++i) {
      const glm::vec3 p = f.positions[i] * sign;
      result.insert({p.x, p.y, p.z, f.colours[i].r});
    }
    return result;
  };
  const std::set<Key> original = keys(glm::vec3(1.0f));
  for (int mirrored = 1; mirrored < 8; ++mirrored) {
    const glm::vec3 sign((mirrored & 1) ? -1.0f : 1.0f, (mirrored & 2) ? -1.0f : 1.0f,
                         (mirrored & 4) ? -1.0f : 1.0f);
    CHECK(keys(sign) != original);
  }
  // Both bars go to the right of the stem, the longer one on top; the front has a colour of its own.
  double top_reach = -1.0, bottom_reach = -1.0;
  for (std::size_t i = 0; i < f.positions.size(); ++i) {
    if (f.positions[i].y == 0.5f) top_reach = std::max<double>(top_reach, f.positions[i].x);
    if (f.positions[i].y == -0.5f) bottom_reach = std::max<double>(bottom_reach, f.positions[i].x);
    const bool is_front = f.normals[i] == glm::vec3(0, 0, 1);
    CHECK((f.colours[i] == f.colours[0]) == is_front);
  }
  CHECK(top_reach == 0.3125);
  CHECK(bottom_reach == -0.125);
}

TEST_CASE("the house has colours, stands on the ground, and its chimney overtops the roof") {
  const Mesh house = shapes::house();
  REQUIRE(house.colours.size() == house.positions.size());
  std::set<std::tuple<float, float, float>> colours;
  for (const glm::vec4& c : house.colours) colours.insert({c.r, c.g, c.b});
  CHECK(colours.size() == 5);
  CHECK(bounds(house).lower.y == 0.0);
  CHECK(bounds(house).upper.y == doctest::Approx(1.18));
}

TEST_CASE("stairs rise away from the viewer") {
  for (const glm::vec3& p : shapes::stairs(4, 1.0f, 0.25f, 0.5f).positions) {
    CHECK(p.y + 0.5f <= (1.0f - p.z) * 0.5f + 0.25f);
  }
}

TEST_CASE("parameters out of range are errors that name the parameter and its range") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto refused = [](const std::string& shape, const std::string& parameter, const std::string& range,
                          auto&& make) {
    expect_error(ErrorKind::usage, {"builtin:" + shape + ": ", parameter + " is ", range}, make);
  };
  const std::string lengths = "from 1e-15 to 1e15";
  for (const float bad : {nan, infinity, -infinity, -1.0f, 0.0f, 1e-20f, 1e20f}) {
    refused("tetrahedron", "circumradius", lengths, [=] { shapes::tetrahedron(bad); });
    refused("octahedron", "circumradius", lengths, [=] { shapes::octahedron(bad); });
    refused("dodecahedron", "circumradius", lengths, [=] { shapes::dodecahedron(bad); });
    refused("icosahedron", "circumradius", lengths, [=] { shapes::icosahedron(bad); });
    refused("cube", "edge", lengths, [=] { shapes::cube(bad); });
    refused("box", "height", lengths, [=] { shapes::box(1.0f, bad, 1.0f); });
    refused("sphere", "radius", lengths, [=] { shapes::sphere(bad); });
    refused("icosphere", "radius", lengths, [=] { shapes::icosphere(bad); });
    refused("cylinder", "height", lengths, [=] { shapes::cylinder(1.0f, bad); });
    refused("cone", "radius", lengths, [=] { shapes::cone(bad); });
    refused("torus", "major_radius", lengths, [=] { shapes::torus(bad); });
    refused("torus", "minor_radius", lengths, [=] { shapes::torus(1.0f, bad); });
    refused("grid", "size", lengths, [=] { shapes::grid(bad); });
    refused("stairs", "tread", lengths, [=] { shapes::stairs(3, 1.0f, 1.0f, bad); });
  }
  refused("torus", "minor_radius", "below major_radius, which is 0.5", [] { shapes::torus(0.5f, 0.5f); });
  for (const int bad : {-5, 0, 2, 65537, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    refused("sphere", "segments", "from 3 to 65536", [=] { shapes::sphere(1.0f, bad); });
    refused("cylinder", "segments", "from 3 to 65536", [=] { shapes::cylinder(1.0f, 1.0f, bad); });
    refused("cone", "segments", "from 3 to 65536", [=] { shapes::cone(1.0f, 1.0f, bad); });
    refused("torus", "minor_segments", "from 3 to 65536", [=] { shapes::torus(1.0f, 0.5f, 9, bad); });
  }
  refused("sphere", "rings", "from 2 to 65536", [] { shapes::sphere(1.0f, 9, 1); });
  refused("icosphere", "subdivisions", "from 0 to 9", [] { shapes::icosphere(1.0f, 10); });
  refused("icosphere", "subdivisions", "from 0 to 9", [] { shapes::icosphere(1.0f, -1); });
  refused("grid", "cells", "from 1 to 4096", [] { shapes::grid(1.0f, 0); });
  refused("stairs", "steps", "from 1 to 65536", [] { shapes::stairs(0); });
  expect_error(ErrorKind::usage, {"builtin:sphere", "8589803520 triangles", "67108864"},
               [] { shapes::sphere(1.0f, 65536, 65536); });
  expect_error(ErrorKind::usage, {"builtin:torus", "triangles"},
               [] { shapes::torus(1.0f, 0.5f, 65536, 65536); });
}
