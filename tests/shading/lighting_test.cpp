#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "shading/shade.hpp"
#include "test_cameras.hpp"

namespace {

constexpr velum::Viewport viewport{64, 48};

void check_close(const glm::vec4& a, const glm::vec4& b) {
  for (int i = 0; i < 4; ++i) CHECK(double(a[i]) == doctest::Approx(double(b[i])).epsilon(1e-6));
}

velum::Material test_material() {
  velum::Material material;
  material.ambient = {1.0f, 0.5f, 0.0f};
  material.diffuse = {1.0f, 1.0f, 0.5f};
  material.specular = {0.2f, 0.4f, 0.0f};
  material.shininess = 2.0f;
  return material;
}

velum::Lighting one_light(const glm::dvec3& to_light) {
  velum::Lighting lighting;
  lighting.ambient = {0.1f, 0.1f, 0.1f};
  lighting.directional = {{-to_light, {2.0f, 1.0f, 1.0f}}};
  return lighting;
}

velum::Scene lit_scene() {
  velum::Mesh mesh = triangle_mesh({-1, -1, 0}, {1, -1, 0}, {0, 1, -1});
  mesh.normals = {glm::normalize(glm::vec3(-0.5f, 0, 1)), glm::normalize(glm::vec3(0.5f, 0, 1)), {0, 0, 1}};
  mesh.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}};
  velum::Scene scene;
  scene.add(mesh, glm::dmat4(1.0), scene.add_material(test_material()));
  return scene;
}

const glm::vec4 base(0.5f, 1.0f, 0.8f, 0.25f);
const glm::vec3 normal(0, 0, 1);
const glm::dvec3 to_viewer(0, 0, 1);

}  // namespace

TEST_CASE("Blinn-Phong equals values worked out by hand") {
  const velum::Material m = test_material();
  SUBCASE("light, viewer and normal together: n·l = n·h = 1") {
    // red 0.1·1·0.5 + 2·(1·0.5·1 + 0.2); green 0.1·0.5·1 + (1 + 0.4); blue 0 + 0.5·0.8
    check_close(velum::blinn_phong(one_light({0, 0, 1}), m, glm::dvec3(0), normal, to_viewer, base),
                {1.45f, 1.45f, 0.4f, 0.25f});
  }
  SUBCASE("light at 60°: n·l = 1/2, n·h = cos 30°, squared 3/4") {
    const glm::dvec3 to_light(std::sqrt(0.75), 0, 0.5);
    check_close(velum::blinn_phong(one_light(to_light), m, glm::dvec3(0), normal, to_viewer, base),
                {0.05f + 2.0f * (0.25f + 0.15f), 0.05f + (0.5f + 0.3f), 0.2f, 0.25f});
  }
  SUBCASE("light below the surface: ambient only, no highlight") {
    const glm::dvec3 to_light(0.999, 0, -std::sqrt(1 - 0.999 * 0.999));
    check_close(velum::blinn_phong(one_light(to_light), m, glm::dvec3(0), normal, {-0.6, 0, 0.8}, base),
                {0.05f, 0.05f, 0.0f, 0.25f});
  }
  SUBCASE("a point light shines from where it is, without falloff") {
    velum::Lighting lighting;
    lighting.points = {{{0, 0, 7}, glm::vec3(1.0f)}};
    check_close(velum::blinn_phong(lighting, m, {0, 0, 1}, normal, to_viewer, base),
                {0.7f, 1.4f, 0.4f, 0.25f});
  }
  SUBCASE("light exactly opposite the viewer has no half vector") {
    const glm::vec4 c = velum::blinn_phong(one_light({0, 0, 1}), m, glm::dvec3(0), normal, {0, 0, -1}, base);
    check_close(c, {1.05f, 1.05f, 0.4f, 0.25f});
  }
}

TEST_CASE("lights of a scene are taken over at unit length; without any there are headlights") {
  velum::Scene scene;
  scene.directional_lights = {{{0, -3, -4}, glm::vec3(0.5f)}};
  velum::Lighting lighting = velum::lighting_of(scene, {0, 0, 1});
  REQUIRE(lighting.directional.size() == 1);
  CHECK(lighting.directional[0].direction.y == doctest::Approx(-0.6));
  scene.directional_lights.clear();
  scene.point_lights = {{}};
  CHECK(velum::lighting_of(scene, {0, 0, 1}).directional.empty());
  scene.point_lights.clear();
  for (const velum::UpAxis up : {velum::UpAxis::y, velum::UpAxis::z}) {
    scene.up = up;
    for (const glm::dvec3& v :
         {glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(1, 2, 3)}) {
      lighting = velum::lighting_of(scene, v);
      REQUIRE(lighting.directional.size() == 2);
      const glm::dvec3 d = lighting.directional[0].direction;
      CHECK(glm::dot(d, d) == doctest::Approx(1.0));
      CHECK(glm::dot(-d, glm::normalize(v)) > 0.9);
      // The second lamp is weaker and stands on the other side.
      CHECK(lighting.directional[1].radiance.x < lighting.directional[0].radiance.x);
      CHECK(glm::dot(lighting.directional[1].direction, d) < 0.75);
    }
  }
}

TEST_CASE("under the headlight the three faces of an isometric cube differ, the top is brightest") {
  const glm::dvec3 d = velum::lighting_of(velum::Scene(), glm::dvec3(1, 1, 1)).directional[0].direction;
  CHECK(-d.y > -d.z + 0.15);
  CHECK(-d.z > -d.x + 0.15);
  CHECK(-d.x > 0.15);
}

TEST_CASE("Gouraud at a vertex is Phong at that vertex, front and back") {
  const velum::Scene scene = lit_scene();
  const velum::Lighting lighting = velum::lighting_of(scene, {0, 0, 1});
  const glm::dmat3 behind(glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1));
  for (const bool back : {false, true}) {
    const TestCamera camera = back ? perspective_camera(behind, {0, 0, -5}, viewport)
                                   : perspective_camera(glm::dmat3(1.0), {0, 0, 5}, viewport);
    const velum::TriangleView t = view_of(scene, camera);
    const velum::LitTriangle lit = velum::light_triangle(velum::Shading::gouraud, lighting, t);
    for (std::size_t i = 0; i < 3; ++i) {
      velum::SurfacePoint point = velum::surface_point(t, 32, 24, 0.5f);
      point.position = t.world[i];
      point.to_viewer = velum::to_viewer_from(t.world[i], t.eye);
      point.shading_normal = t.normals[i];
      point.barycentric = glm::vec3(i == 0, i == 1, i == 2);
      point.colour = t.colours[i];
      const glm::vec4 gouraud = velum::shade(velum::Shading::gouraud, lighting, lit, point, {});
      const glm::vec4 phong = velum::shade(velum::Shading::phong, lighting, lit, point, {});
      for (int channel = 0; channel < 4; ++channel)
        CHECK(gouraud[channel] == doctest::Approx(phong[channel]).epsilon(1e-6));
    }
  }
}

TEST_CASE("flat shading is lit once, at the centroid with the geometric normal") {
  const velum::Scene scene = lit_scene();
  const velum::Lighting lighting = velum::lighting_of(scene, {0, 0, 1});
  const TestCamera camera = perspective_camera(glm::dmat3(1.0), {0, 0, 5}, viewport);
  const velum::TriangleView t = view_of(scene, camera);
  const velum::LitTriangle lit = velum::light_triangle(velum::Shading::flat, lighting, t);
  const glm::dvec3 centroid(0, -1.0 / 3.0, -1.0 / 3.0);
  const glm::vec4 mean = (t.colours[0] + t.colours[1] + t.colours[2]) / 3.0f;
  check_close(lit.face,
              velum::blinn_phong(lighting, *t.material, centroid, glm::normalize(glm::vec3(0, 1, 2)),
                                 glm::normalize(glm::dvec3(0, 0, 5) - centroid), mean));
  for (const int x : {30, 33}) {
    const velum::SurfacePoint point = velum::surface_point(t, x, 24, 0.5f);
    CHECK(velum::shade(velum::Shading::flat, lighting, lit, point, {}) == lit.face);
  }
}
