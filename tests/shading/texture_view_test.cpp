#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include "base/plane.hpp"
#include "shading/shade.hpp"
#include "test_cameras.hpp"

using velum::TriangleView;

namespace {

constexpr velum::Viewport viewport{64, 48};

/// Texture coordinates where the projector through a place in the picture meets the triangle's plane: from
/// geometry alone, with barycentrics as ratios of areas in the plane.
glm::dvec2 coordinates_at(const TriangleView& t, const TestCamera& camera, double px, double py) {
  const glm::dmat4 world_from_clip = glm::inverse(camera.clip_from_world);
  const glm::dvec2 ndc = viewport.ndc_from_pixel(px, py);
  const glm::dvec4 a = world_from_clip * glm::dvec4(ndc, 0.0, 1.0),
                   b = world_from_clip * glm::dvec4(ndc, 1.0, 1.0);
  const glm::dvec3 from = glm::dvec3(a) / a.w, direction = glm::dvec3(b) / b.w - from;
  const velum::Plane plane = velum::Plane::through(t.world[0], t.world[1], t.world[2]);
  const glm::dvec3 hit = from + direction * (-plane.signed_value(from) / glm::dot(plane.normal, direction));
  const glm::dvec3 normal = glm::cross(t.world[1] - t.world[0], t.world[2] - t.world[0]);
  glm::dvec2 sum(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 p = t.world[(i + 1) % 3] - hit, q = t.world[(i + 2) % 3] - hit;
    sum += glm::dvec2(t.texture_coordinates[i]) *
           (glm::dot(glm::cross(p, q), normal) / glm::dot(normal, normal));
  }
  return sum;
}

/// Central differences with a step of a thousandth of a pixel.
glm::dmat2 differences_at(const TriangleView& t, const TestCamera& camera, double px, double py) {
  constexpr double h = 1e-3;
  return {(coordinates_at(t, camera, px + h, py) - coordinates_at(t, camera, px - h, py)) / (2 * h),
          (coordinates_at(t, camera, px, py + h) - coordinates_at(t, camera, px, py - h)) / (2 * h)};
}

velum::Image<velum::Rgba8> checker_picture(int cells, int texels_per_cell) {
  const int size = cells * texels_per_cell;
  velum::Image<velum::Rgba8> picture(size, size, velum::Rgba8{0, 0, 0, 255});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      if ((x / texels_per_cell + y / texels_per_cell) % 2 == 0) picture.at(x, y) = {255, 255, 255, 255};
    }
  }
  return picture;
}

/// A checkerboard of unit cells in the plane y = 0, from far left and behind the viewer to the horizon.
velum::Scene checker_plane() {
  constexpr float far = 4000.0f;
  velum::Mesh mesh;
  mesh.positions = {{-far, 0, 50}, {far, 0, 50}, {0, 0, -far}};
  std::vector<glm::vec2> coordinates;
  for (const glm::vec3& p : mesh.positions) coordinates.emplace_back(p.x / 2.0f, -p.z / 2.0f);
  mesh.texture_coordinates = coordinates;
  mesh.triangles = {glm::uvec3(0, 1, 2)};
  velum::Material material;
  material.base_colour = glm::vec3(1.0f);
  material.texture = std::make_shared<const velum::Texture>(checker_picture(2, 32));
  velum::Scene scene;
  scene.add(mesh, glm::dmat4(1.0), scene.add_material(material));
  return scene;
}

TestCamera level_camera(const glm::dvec3& position) {
  return perspective_camera(glm::dmat3(1.0), position, viewport);
}

}  // namespace

TEST_CASE("texture derivatives agree with differences of the ray's hit, vertices behind the viewer too") {
  Random random{31};
  int tested = 0, behind = 0;
  for (int i = 0; i < 150; ++i) {
    velum::Mesh mesh = random_triangle_mesh(random);
    std::vector<glm::vec2> coordinates;
    for (int k = 0; k < 3; ++k) coordinates.emplace_back(random.uniform(-3, 3), random.uniform(-3, 3));
    mesh.texture_coordinates = coordinates;
    velum::Scene scene;
    scene.add(mesh);
    for (const TestCamera& camera : random_cameras(random, viewport)) {
      const TriangleView t = view_of(scene, camera);
      for (int y = 2; y < viewport.height; y += 11) {
        for (int x = 2; x < viewport.width; x += 13) {
          const glm::dvec3 b = velum::barycentrics_at(t, x + 0.5, y + 0.5).exact;
          const double w = t.clip[0].w * b.x + t.clip[1].w * b.y + t.clip[2].w * b.z;
          if (b.x < 0 || b.y < 0 || b.z < 0 || w < 0.1) continue;
          const glm::dmat2 expected = differences_at(t, camera, x + 0.5, y + 0.5);
          const velum::SurfacePoint point = velum::surface_point(t, x, y, 0.5f);
          const double size = glm::length(expected[0]) + glm::length(expected[1]);
          CHECK(glm::length(point.texture_dx - expected[0]) <= 1e-4 * size);
          CHECK(glm::length(point.texture_dy - expected[1]) <= 1e-4 * size);
          ++tested;
          if (!t.is_in_front) ++behind;
        }
      }
    }
  }
  CHECK(tested > 300);
  CHECK(behind > 20);
}

TEST_CASE("a triangle without texture coordinates or seen edge-on has no derivatives") {
  velum::Scene scene;
  scene.add(triangle_mesh({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}));
  velum::Mesh edge_on = triangle_mesh({0, -1, 0}, {0, -1, -2}, {0, 1, 0});
  edge_on.texture_coordinates = {{0, 0}, {1, 0}, {0, 1}};
  scene.add(edge_on);
  const TestCamera camera = level_camera({0, 0, 4});
  for (const std::uint32_t instance : {0u, 1u}) {
    const velum::SurfacePoint point = velum::surface_point(view_of(scene, camera, instance), 32, 24, 0.5f);
    CHECK(point.texture_dx == glm::dvec2(0.0));
    CHECK(point.texture_dy == glm::dvec2(0.0));
  }
}

TEST_CASE("a checkerboard fades to its mean at the horizon and does not shimmer when the viewer moves") {
  const velum::Scene scene = checker_plane();
  // One unit above the plane, rows below 24: row y looks at distance 48 / (y - 23.5).
  double largest_far = 0.0, least = 1.0, most = 0.0, largest_without = 0.0;
  for (const double shift : {0.0, 0.13, 0.37, 0.61, 0.89}) {
    TriangleView t = view_of(scene, level_camera({shift, 1.0, shift}));
    for (int x = 0; x < viewport.width; ++x) {
      for (const int y : {24, 25}) {  // some 32 to 96 units away: a pixel covers more than a cell each way
        const double grey = static_cast<double>(velum::surface_point(t, x, y, 0.5f).texel.r);
        largest_far = std::max(largest_far, std::abs(grey - 0.5));
      }
      const double near = static_cast<double>(velum::surface_point(t, x, 47, 0.5f).texel.r);
      least = std::min(least, near);
      most = std::max(most, near);
    }
    t.texture_filter = velum::TextureFilter::bilinear;
    for (int x = 0; x < viewport.width; ++x)
      largest_without = std::max(
          largest_without, std::abs(static_cast<double>(velum::surface_point(t, x, 24, 0.5f).texel.r) - 0.5));
  }
  MESSAGE("far from grey: ", largest_far, ", without mipmaps: ", largest_without);
  CHECK(largest_far < 0.02);
  CHECK(largest_without > 0.45);
  CHECK(least < 0.01);
  CHECK(most > 0.99);
}

TEST_CASE("across the view the checkerboard keeps its columns where along it the rows have merged") {
  const velum::Scene scene = checker_plane();
  const TriangleView t = view_of(scene, level_camera({0.0, 1.0, 0.0}));
  // Rotate the checks by half: stripes that run away from the viewer are 3 pixels wide at 16 units.
  velum::Image<velum::Rgba8> stripes(64, 64, velum::Rgba8{0, 0, 0, 255});
  for (int y = 0; y < 64; ++y)
    std::fill(stripes.row(y), stripes.row(y) + 32, velum::Rgba8{255, 255, 255, 255});
  velum::Material material;
  material.texture = std::make_shared<const velum::Texture>(stripes);
  TriangleView striped = t;
  striped.material = &material;
  double least = 1.0, most = 0.0;
  for (int x = 8; x < 56; ++x) {
    const double grey = static_cast<double>(velum::surface_point(striped, x, 26, 0.5f).texel.r);
    least = std::min(least, grey);
    most = std::max(most, grey);
  }
  CHECK(least < 0.1);
  CHECK(most > 0.9);
}

TEST_CASE("base colour, vertex colour and texel are multiplied, alpha too; the mapping moves the texture") {
  velum::Mesh mesh = triangle_mesh({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  mesh.texture_coordinates = {{0.25f, 0.25f}, {0.25f, 0.25f}, {0.25f, 0.25f}};
  mesh.colours = {{0.5f, 1, 1, 0.5f}, {0.5f, 1, 1, 0.5f}, {0.5f, 1, 1, 0.5f}};
  velum::Image<velum::Rgba8> picture(2, 1);
  picture.at(0, 0) = {255, 188, 0, 255};
  picture.at(1, 0) = {0, 0, 255, 51};
  velum::Material material;
  material.base_colour = {0.5f, 0.5f, 0.5f};
  material.alpha = 0.5f;
  material.texture = std::make_shared<const velum::Texture>(picture);
  const float green = velum::linear_from_srgb(188);
  const auto colour_with = [&](const velum::TextureMapping& mapping) {
    material.texture_mapping = mapping;
    velum::Scene scene;
    scene.add(mesh, glm::dmat4(1.0), scene.add_material(material));
    return velum::surface_point(view_of(scene, level_camera({0, 0, 5})), 32, 24, 0.5f).colour;
  };
  CHECK(glm::length(colour_with({}) - glm::vec4(0.25f, 0.5f * green, 0, 0.25f)) < 1e-6f);
  CHECK(glm::length(colour_with({{}, {1, 1}, {0.5f, 0}}) - glm::vec4(0, 0, 0.5f, 0.05f)) < 1e-6f);
  CHECK(glm::length(colour_with({{}, {3, 1}, {0, 0}}) - glm::vec4(0, 0, 0.5f, 0.05f)) < 1e-6f);
}

TEST_CASE("a texture of one colour is that base colour in every lit shading: the highlight stays white") {
  velum::Mesh mesh = triangle_mesh({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  mesh.texture_coordinates = {{0, 0}, {1, 0}, {0, 1}};
  velum::Material plain;
  plain.specular = glm::vec3(0.5f);
  plain.shininess = 4.0f;
  velum::Material textured = plain;
  textured.base_colour = glm::vec3(1.0f);
  textured.texture = std::make_shared<const velum::Texture>(
      velum::Image<velum::Rgba8>(3, 3, velum::Rgba8{255, 120, 0, 255}));
  plain.base_colour = {1.0f, velum::linear_from_srgb(120), 0.0f};
  velum::Scene scene;
  scene.add(mesh, glm::dmat4(1.0), scene.add_material(plain));
  scene.add(mesh, glm::dmat4(1.0), scene.add_material(textured));
  const TestCamera camera = level_camera({0.3, 0.2, 5});
  const velum::Lighting lighting = velum::lighting_of(scene, {0, 0, 1});
  for (const velum::Shading shading :
       {velum::Shading::flat, velum::Shading::gouraud, velum::Shading::phong}) {
    glm::vec4 colours[2];
    for (std::uint32_t i = 0; i < 2; ++i) {
      const TriangleView t = view_of(scene, camera, i);
      const velum::LitTriangle lit = velum::light_triangle(shading, lighting, t);
      colours[i] = velum::shade(shading, lighting, lit, velum::surface_point(t, 30, 25, 0.5f), {});
    }
    CHECK(glm::length(colours[0] - colours[1]) < 1e-6f);
    CHECK(colours[0].b > 0.01f);
  }
}
