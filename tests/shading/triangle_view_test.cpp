#include "shading/triangle_view.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "test_cameras.hpp"

namespace {

constexpr velum::Viewport viewport{64, 48};

double largest_difference(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z});
}

/// The same by solving [x; y; w]·b ∝ (x, y, 1) with full pivoting.
glm::dvec3 solved_barycentrics(const velum::TriangleView& t, const glm::dvec2& ndc) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec4& v = t.clip[static_cast<std::size_t>(i)];
    m.col(i) = Eigen::Vector3d(v.x, v.y, v.w);
  }
  const Eigen::Vector3d b = m.fullPivLu().solve(Eigen::Vector3d(ndc.x, ndc.y, 1.0));
  const double sum = b.sum();
  return {b.x() / sum, b.y() / sum, b.z() / sum};
}

}  // namespace

TEST_CASE("barycentrics equal those of the linear system, also with vertices behind the viewer") {
  Random random{11};
  int behind = 0, tested = 0;
  for (int i = 0; i < 400; ++i) {
    velum::Scene scene;
    scene.add(random_triangle_mesh(random));
    for (const TestCamera& camera : random_cameras(random, viewport)) {
      const velum::TriangleView t = view_of(scene, camera);
      if (std::abs(t.determinant) < 1e-3) continue;
      glm::dvec3 b = random_vector(random, 0.01, 1.0);
      b /= b.x + b.y + b.z;
      const glm::dvec4 p = t.clip[0] * b.x + t.clip[1] * b.y + t.clip[2] * b.z;
      if (p.w < 0.05) continue;
      const glm::dvec2 pixel = viewport.pixel_from_ndc(p.x / p.w, p.y / p.w);
      const velum::Barycentrics found = velum::barycentrics_at(t, pixel.x, pixel.y);
      CHECK(largest_difference(found.exact, b) < 1e-9);
      CHECK(largest_difference(found.exact, solved_barycentrics(t, {p.x / p.w, p.y / p.w})) < 1e-9);
      CHECK(largest_difference(found.clamped, b) < 1e-9);
      ++tested;
      if (!t.is_in_front) ++behind;
    }
  }
  CHECK(tested > 800);
  CHECK(behind > 20);
}

TEST_CASE("outside the triangle, clamped barycentrics are a point of the triangle") {
  velum::Scene scene;
  scene.add(triangle_mesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
  const velum::TriangleView t = view_of(scene, parallel_camera(glm::dmat3(1.0), {0, 0, 5}, viewport, {0, 0}));
  // Pixels per world unit: 48/6 = 8; the origin is at (32, 24). World (0.5, -0.25) lies below edge y = 0.
  const velum::Barycentrics b = velum::barycentrics_at(t, 36.0, 26.0);
  CHECK(largest_difference(b.exact, {0.75, 0.5, -0.25}) < 1e-12);
  CHECK(largest_difference(b.clamped, {0.6, 0.4, 0.0}) < 1e-12);
}

TEST_CASE("small triangles far from the picture's centre keep accurate barycentrics") {
  velum::Scene scene;
  const float s = 0x1p-20f;  // 1/131072 pixel
  scene.add(triangle_mesh({2, 2, 0}, {2 + s, 2, 0}, {2, 2 + s, 0}));
  const velum::TriangleView t = view_of(scene, parallel_camera(glm::dmat3(1.0), {0, 0, 5}, viewport, {0, 0}));
  const velum::Barycentrics b = velum::barycentrics_at(t, 48.0 + 2.0 * double(s), 8.0 - 4.0 * double(s));
  CHECK(largest_difference(b.exact, {0.25, 0.25, 0.5}) < 1e-7);
}

TEST_CASE("a triangle seen edge-on has the attributes of its nearest vertex") {
  velum::Scene scene;
  velum::Mesh mesh = triangle_mesh({0, 0, 0}, {0, 0, 2}, {0, 1, 0});
  mesh.texture_coordinates = {{0, 0}, {1, 0}, {0, 1}};
  scene.add(mesh);
  const TestCamera camera = perspective_camera(glm::dmat3(1.0), {0, 0, 5}, viewport);
  const velum::TriangleView t = view_of(scene, camera);
  CHECK(t.determinant == 0.0);
  CHECK(t.facing == velum::Facing::front);
  const velum::Barycentrics b = velum::barycentrics_at(t, 32.0, 20.0);
  CHECK(b.exact == glm::dvec3(0, 1, 0));
  CHECK(b.clamped == glm::dvec3(0, 1, 0));
  const velum::SurfacePoint point = velum::surface_point(t, 31, 20, 0.5f);
  CHECK(point.position == glm::dvec3(0, 0, 2));
  CHECK(point.texture_coordinate == glm::vec2(1, 0));
  CHECK(point.metric_depth == doctest::Approx(3.0).epsilon(1e-12));
}

TEST_CASE("facing, π·e, line of sight and half-space agree under every camera; mirroring flips") {
  Random random{13};
  int back = 0, tested = 0;
  for (int i = 0; i < 300; ++i) {
    const velum::Mesh mesh = random_triangle_mesh(random);
    glm::dmat4 mirror(1.0);
    mirror[0][0] = -1.0;
    velum::Scene scene;
    scene.add(mesh);
    scene.add(mesh, mirror);
    for (const TestCamera& camera : random_cameras(random, viewport)) {
      for (const std::uint32_t instance : {0u, 1u}) {
        const velum::TriangleView t = view_of(scene, camera, instance);
        const velum::Plane plane = velum::Plane::through(t.world[0], t.world[1], t.world[2]);
        const glm::dvec4& eye = camera.viewer.eye;
        const double side = velum::side_of_viewer(plane, eye);
        if (std::abs(side) < 1e-6) continue;
        CHECK((t.determinant > 0.0) == (side > 0.0));
        CHECK((velum::line_of_sight_test(plane, t.world[2], eye) < 0.0) == (side > 0.0));
        if (eye.w != 0.0) CHECK((velum::half_space_test(plane, glm::dvec3(eye)) > 0.0) == (side > 0.0));
        CHECK((t.facing == velum::Facing::back) == ((side < 0.0) != (instance == 1)));
        ++tested;
        if (t.facing == velum::Facing::back) ++back;
      }
    }
  }
  CHECK(back > tested / 3);
  CHECK(back < tested * 2 / 3);
}
