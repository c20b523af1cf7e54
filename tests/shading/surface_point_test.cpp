#include "shading/surface_point.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "test_cameras.hpp"

namespace {

constexpr velum::Viewport viewport{64, 48};

double length(const glm::vec3& v) {
  return std::sqrt(glm::dot(glm::dvec3(v), glm::dvec3(v)));
}

void check_close(const glm::vec3& a, const glm::vec3& b) {
  CHECK(length(a - b) < 1e-6);
}

/// Where the projector through the pixel's centre meets the triangle's plane: from geometry alone.
glm::dvec3 hit(const velum::TriangleView& t, const TestCamera& camera, int x, int y) {
  const glm::dmat4 world_from_clip = glm::inverse(camera.clip_from_world);
  const glm::dvec2 ndc = viewport.ndc_from_pixel(x + 0.5, y + 0.5);
  const glm::dvec4 a = world_from_clip * glm::dvec4(ndc, 0.0, 1.0),
                   b = world_from_clip * glm::dvec4(ndc, 1.0, 1.0);
  const glm::dvec3 from = glm::dvec3(a) / a.w, direction = glm::dvec3(b) / b.w - from;
  const velum::Plane plane = velum::Plane::through(t.world[0], t.world[1], t.world[2]);
  return from + direction * (-plane.signed_value(from) / glm::dot(plane.normal, direction));
}

void check_point(const velum::TriangleView& t, const TestCamera& camera, int x, int y) {
  const velum::SurfacePoint point = velum::surface_point(t, x, y, 0.25f);
  CHECK(length(glm::vec3(point.position - hit(t, camera, x, y))) < 1e-6);
  const glm::dvec4 clip = camera.clip_from_world * glm::dvec4(point.position, 1.0);
  const glm::dvec2 pixel = viewport.pixel_from_ndc(clip.x / clip.w, clip.y / clip.w);
  CHECK(std::abs(pixel.x - (x + 0.5)) < 1e-7);
  CHECK(std::abs(pixel.y - (y + 0.5)) < 1e-7);
  const double along_look = glm::dot(camera.viewer.metric_depth_plane, glm::dvec4(hit(t, camera, x, y), 1.0));
  CHECK(std::abs(point.metric_depth - along_look) <= 1e-5 * std::abs(along_look));
  CHECK(std::abs(glm::dot(point.to_viewer, point.to_viewer) - 1.0) < 1e-12);
  CHECK(glm::dot(glm::dvec3(point.geometric_normal), point.to_viewer) > 0.0);
  CHECK(length(point.geometric_normal) == doctest::Approx(1.0).epsilon(1e-6));
  CHECK(point.barycentric.x + point.barycentric.y + point.barycentric.z ==
        doctest::Approx(1.0).epsilon(1e-6));
  CHECK(point.depth == 0.75f);
  CHECK(point.x == x);
  CHECK(point.y == y);
}

/// A triangle in the xy plane, counter-clockwise from +z, with three different normals.
velum::Mesh facing_z() {
  velum::Mesh mesh = triangle_mesh({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  mesh.normals = {glm::normalize(glm::vec3(-0.5f, 0, 1)), glm::normalize(glm::vec3(0.5f, 0, 1)),
                  glm::normalize(glm::vec3(0, 0.5f, 1))};
  return mesh;
}

glm::dmat3 from_behind() {
  return {glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1)};
}

}  // namespace

TEST_CASE("surface points lie on the triangle, under the pixel's centre, at the metric depth") {
  Random random{21};
  int tested = 0, behind = 0;
  for (int i = 0; i < 60; ++i) {
    velum::Scene scene;
    glm::dmat4 placed(random_rotation(random));
    placed[3] = glm::dvec4(random_vector(random, -1, 1), 1.0);
    if (i % 2 == 1) placed[1] = -placed[1];
    scene.add(random_triangle_mesh(random), placed);
    for (const TestCamera& camera : random_cameras(random, viewport)) {
      const velum::TriangleView t = view_of(scene, camera);
      if (std::abs(t.determinant) < 1e-2) continue;
      for (int y = 0; y < viewport.height; y += 5) {
        for (int x = 0; x < viewport.width; x += 5) {
          const glm::dvec3 b = velum::barycentrics_at(t, x + 0.5, y + 0.5).exact;
          const double w = t.clip[0].w * b.x + t.clip[1].w * b.y + t.clip[2].w * b.z;
          if (b.x < 0 || b.y < 0 || b.z < 0 || w < 0.1) continue;
          check_point(t, camera, x, y);
          ++tested;
          if (!t.is_in_front) ++behind;
        }
      }
    }
  }
  CHECK(tested > 500);
  CHECK(behind > 50);
}

TEST_CASE("metric depth keeps its accuracy far from the origin and just outside the triangle") {
  velum::Scene scene;
  const glm::dvec3 away(10000.0, 10000.0, 10000.0);
  glm::dmat4 moved(1.0);
  moved[3] = glm::dvec4(away, 1.0);
  scene.add(triangle_mesh({-1, -1, 0}, {1, -1, 0}, {0, 1, 1}), moved);
  const TestCamera camera = perspective_camera(glm::dmat3(1.0), away + glm::dvec3(0, 0, 4), viewport);
  const velum::TriangleView t = view_of(scene, camera);
  for (int y = 12; y < 40; ++y) {
    const double depth = velum::surface_point(t, 32, y, 0.5f).metric_depth;
    CHECK(depth >= 3.0 - 1e-9);
    CHECK(depth <= 4.0 + 1e-9);
  }
  // The plane is z = (y+1)/2; the projector is y = -v·d, z = 4 - d with v = (row - 24)/48.
  const double v = (27.5 - 24.0) / 48.0, expected = 3.5 / (1.0 - v / 2.0);
  CHECK(velum::surface_point(t, 32, 27, 0.5f).metric_depth == doctest::Approx(expected).epsilon(1e-9));
  CHECK(velum::barycentrics_at(t, 55.5, 27.5).exact.x < -0.1);
  CHECK(velum::surface_point(t, 55, 27, 0.5f).metric_depth == doctest::Approx(expected).epsilon(1e-9));
}

TEST_CASE("a back face is shaded two-sided: both normals turn together") {
  velum::Scene scene;
  scene.add(facing_z());
  const velum::TriangleView front = view_of(scene, perspective_camera(glm::dmat3(1.0), {0, 0, 5}, viewport));
  const velum::TriangleView back = view_of(scene, perspective_camera(from_behind(), {0, 0, -5}, viewport));
  CHECK(front.facing == velum::Facing::front);
  CHECK(back.facing == velum::Facing::back);
  CHECK(front.geometric_normal == glm::vec3(0, 0, 1));
  CHECK(back.geometric_normal == glm::vec3(0, 0, -1));
  for (std::size_t i = 0; i < 3; ++i) check_close(back.normals[i], -front.normals[i]);
  CHECK(velum::surface_point(back, 32, 24, 0.5f).back_facing);
  CHECK_FALSE(velum::surface_point(front, 32, 24, 0.5f).back_facing);
}

TEST_CASE("a mirrored instance keeps outward normals outward") {
  velum::Scene scene;
  glm::dmat4 mirror(1.0);
  mirror[0][0] = -2.0;
  scene.add(facing_z(), mirror);
  const velum::TriangleView t = view_of(scene, perspective_camera(glm::dmat3(1.0), {0, 0, 5}, viewport));
  CHECK(t.determinant < 0.0);
  CHECK(t.facing == velum::Facing::front);
  CHECK(t.geometric_normal == glm::vec3(0, 0, 1));
  check_close(t.normals[0], glm::normalize(glm::vec3(0.25f, 0, 1)));  // inverse transpose: x / -2
  check_close(t.normals[2], glm::normalize(glm::vec3(0, 0.5f, 1)));
  const velum::TriangleView back = view_of(scene, perspective_camera(from_behind(), {0, 0, -5}, viewport));
  CHECK(back.facing == velum::Facing::back);
  check_close(back.normals[0], -t.normals[0]);
  const glm::dmat3 from_the_side(glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0));
  const velum::TriangleView edge_on = view_of(scene, perspective_camera(from_the_side, {5, 0, 0}, viewport));
  CHECK(edge_on.determinant == 0.0);
  CHECK(edge_on.geometric_normal == glm::vec3(0, 0, 1));
}

TEST_CASE("normals stay perpendicular to the surface under an uneven scale and shear") {
  Random random{22};
  for (int i = 0; i < 50; ++i) {
    velum::Mesh mesh = random_triangle_mesh(random);
    const glm::vec3 n = glm::normalize(
        glm::cross(mesh.positions[1] - mesh.positions[0], mesh.positions[2] - mesh.positions[0]));
    mesh.normals = {n, n, n};
    glm::dmat4 m(random_rotation(random));
    m[0] *= 3.0;
    m[1] += m[0] * random.uniform(-1, 1);
    if (i % 2 == 1) m[2] = -m[2];
    velum::Scene scene;
    scene.add(mesh, m);
    for (const TestCamera& camera : random_cameras(random, viewport)) {
      const velum::TriangleView t = view_of(scene, camera);
      if (std::abs(t.determinant) < 1e-6) continue;
      CHECK(length(t.normals[0] - t.geometric_normal) < 1e-4);
    }
  }
}

TEST_CASE("missing, zero and unusable vertex normals fall back to the geometric normal") {
  const TestCamera camera = perspective_camera(glm::dmat3(1.0), {0, 0, 5}, viewport);
  velum::Mesh mesh = facing_z();
  mesh.normals = {};
  velum::Scene without;
  without.add(mesh);
  CHECK(velum::surface_point(view_of(without, camera), 32, 24, 0.5f).shading_normal == glm::vec3(0, 0, 1));
  mesh.normals = {glm::vec3(0), glm::vec3(std::nanf("")), glm::vec3(1e-30f, 0, 0)};
  velum::Scene broken;
  broken.add(mesh);
  const velum::TriangleView t = view_of(broken, camera);
  CHECK(t.normals[0] == glm::vec3(0, 0, 1));
  CHECK(t.normals[1] == glm::vec3(0, 0, 1));
  CHECK(t.normals[2] == glm::vec3(1, 0, 0));
}

TEST_CASE("colours and texture coordinates are interpolated perspective-correctly") {
  velum::Mesh mesh = triangle_mesh({-1, -1, 0}, {1, -1, 0}, {-1, -1, -8});  // a floor going away
  mesh.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}};
  mesh.texture_coordinates = {{0, 0}, {1, 0}, {0, 1}};
  velum::Scene scene;
  velum::Material material;
  material.base_colour = {0.5f, 1.0f, 0.25f};
  material.alpha = 0.5f;
  const std::uint32_t index = scene.add_material(material);
  scene.add(mesh, glm::dmat4(1.0), index);
  const TestCamera camera = perspective_camera(glm::dmat3(1.0), {0, 0, 4}, viewport);
  const velum::TriangleView t = view_of(scene, camera);
  // Row 30: v = 6.5/48, the floor y = -1 is met at distance 1/v; share of the way to the far vertex (d -
  // 4)/8.
  const double share = (48.0 / 6.5 - 4.0) / 8.0;
  const velum::SurfacePoint point = velum::surface_point(t, 26, 30, 0.5f);
  CHECK(double(point.barycentric.z) == doctest::Approx(share).epsilon(1e-6));
  CHECK(double(point.texture_coordinate.y) == doctest::Approx(share).epsilon(1e-6));
  CHECK(double(point.colour.b) == doctest::Approx(0.25 * share).epsilon(1e-6));
  CHECK(double(point.colour.a) == doctest::Approx(0.5 * (1.0 - 0.5 * share)).epsilon(1e-6));
  CHECK(point.material == &scene.materials()[index]);
}
