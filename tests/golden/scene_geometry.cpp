#include "scene_geometry.hpp"

#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace golden {
namespace {

using namespace velum;

constexpr glm::vec3 red{0.8f, 0.08f, 0.06f};
constexpr glm::vec3 green{0.1f, 0.6f, 0.12f};
constexpr glm::vec3 blue{0.08f, 0.2f, 0.8f};
constexpr glm::vec3 yellow{0.85f, 0.7f, 0.05f};

std::uint32_t paint(Scene& scene, const glm::vec3& colour, float alpha = 1.0f) {
  Material material;
  material.base_colour = colour;
  material.alpha = alpha;
  return scene.add_material(material);
}

glm::dmat4 placed(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& at) {
  return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(at, 1.0)};
}

glm::dmat4 at(double x, double y, double z) {
  return placed({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {x, y, z});
}

Mesh triangles(std::vector<glm::vec3> positions, std::vector<glm::uvec3> indices) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(indices);
  return mesh;
}

/// Corners in order around.
Mesh quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
  return triangles({a, b, c, d}, {{0, 1, 2}, {0, 2, 3}});
}

void add_solids(Scene& scene, const glm::dvec3& offset) {
  scene.add(shapes::house(), at(offset.x, offset.y, offset.z), paint(scene, yellow));
  scene.add(shapes::letter_f(),
            placed({0.7, 0.0, 0.2}, {0.0, 1.1, 0.0}, {-0.1, 0.0, 0.9}, offset + glm::dvec3(0.6, 0.9, 0.7)),
            paint(scene, red));
  scene.add(
      shapes::torus(0.5f, 0.15f, 24, 12),
      placed({0.36, 0.48, -0.8}, {-0.8, 0.6, 0.0}, {0.48, 0.64, 0.6}, offset + glm::dvec3(0.1, 0.4, 0.9)),
      paint(scene, blue));
}

}  // namespace

Scene solids() {
  Scene scene;
  add_solids(scene, glm::dvec3(0.0));
  return scene;
}

Scene mirrored() {
  Scene scene;
  const Mesh letter = shapes::letter_f();
  const std::uint32_t mesh = scene.add_mesh(letter);
  const auto add = [&](const glm::dvec3& signs, const glm::dvec3& position, const glm::vec3& colour) {
    const glm::dmat4 matrix = placed({signs.x, 0.0, 0.0}, {0.0, signs.y, 0.0}, {0.0, 0.0, signs.z}, position);
    scene.add_instance({mesh, paint(scene, colour), matrix, {}});
  };
  add({1.0, 1.0, 1.0}, {-0.7, 0.7, 0.0}, red);
  add({-1.0, 1.0, 1.0}, {0.7, 0.7, 0.0}, green);
  add({1.0, 1.0, -1.0}, {-0.7, -0.7, 0.0}, blue);
  add({-1.0, -1.0, -1.0}, {0.7, -0.7, 0.0}, yellow);
  return scene;
}

Scene interpenetrating() {
  Scene scene;
  scene.add(triangles({{-1.0f, -0.9f, 0.6f}, {1.1f, -0.2f, -0.7f}, {-0.3f, 1.2f, 0.1f}}, {{0, 1, 2}}),
            glm::dmat4(1.0), paint(scene, red));
  scene.add(triangles({{1.0f, -0.8f, 0.7f}, {0.2f, 1.1f, 0.3f}, {-1.1f, -0.1f, -0.5f}}, {{0, 1, 2}}),
            glm::dmat4(1.0), paint(scene, green));
  scene.add(triangles({{-0.9f, 0.6f, 0.5f}, {0.1f, -1.0f, -0.2f}, {1.0f, 0.7f, 0.4f}}, {{0, 1, 2}}),
            glm::dmat4(1.0), paint(scene, blue));
  scene.add(shapes::cube(0.5f), at(0.75, 0.55, 0.2), paint(scene, yellow));
  scene.add(shapes::sphere(0.33f, 24, 12), at(0.75, 0.55, 0.2), paint(scene, red));
  return scene;
}

Scene ties() {
  Scene scene;
  const std::uint32_t first = paint(scene, red);
  const std::uint32_t second = paint(scene, green);
  // Twins: only red may be seen of them.
  scene.add(shapes::cube(0.8f), at(-0.6, 0.0, 0.0), first);
  scene.add(shapes::cube(0.8f), at(-0.6, 0.0, 0.0), second);
  const Mesh sheet = quad({0.0f, -0.8f, 0.4f}, {1.0f, -0.8f, 0.4f}, {1.0f, 0.2f, 0.4f}, {0.0f, 0.2f, 0.4f});
  scene.add(sheet, glm::dmat4(1.0), first);
  scene.add(sheet, glm::dmat4(1.0), second);
  // Coplanar with the sheet and with the cubes' fronts, but later: seen from the front, all its depths tie,
  // and it shows only where nothing else is. Elsewhere rounding decides, the same everywhere.
  scene.add(quad({-0.4f, -0.6f, 0.4f}, {0.6f, -0.6f, 0.4f}, {0.6f, 0.7f, 0.4f}, {-0.4f, 0.7f, 0.4f}),
            glm::dmat4(1.0), paint(scene, blue));
  return scene;
}

Scene slivers() {
  Scene scene;
  constexpr int count = 720;
  std::vector<glm::vec3> rim{{0.0f, 0.0f, 0.0f}};
  std::vector<glm::uvec3> fan;
  for (int i = 0; i < count; ++i) {
    const double angle = radians(360.0 / count * i);
    rim.emplace_back(0.7 * elementary::cos(angle), 0.7 * elementary::sin(angle), 0.2);
    const auto next = static_cast<std::uint32_t>((i + 1) % count);
    fan.emplace_back(0u, static_cast<std::uint32_t>(i + 1), next + 1);
  }
  scene.add(triangles(rim, fan), glm::dmat4(1.0), paint(scene, yellow));
  std::vector<glm::vec3> points;
  std::vector<glm::uvec3> needles;
  double width = 0.08;
  for (std::uint32_t i = 0; i < 24; ++i, width *= 0.75) {
    const double angle = radians(15.0 * i);
    const glm::dvec3 along(elementary::cos(angle), elementary::sin(angle), 0.0);
    const glm::dvec3 across(-along.y * width, along.x * width, 0.0);
    points.insert(points.end(), {glm::vec3(0.5 * along - across), glm::vec3(0.5 * along + across),
                                 glm::vec3(1.2 * along + glm::dvec3(0.0, 0.0, 0.6))});
    needles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  scene.add(triangles(points, needles), glm::dmat4(1.0), paint(scene, red));
  return scene;
}

Scene sub_pixel() {
  Scene scene;
  const std::uint32_t ball = scene.add_mesh(shapes::icosphere(0.35f, 3));
  scene.add_instance({ball, paint(scene, red), at(-1.1, -0.9, 0.5), {}});
  scene.add_instance({ball, paint(scene, green), at(1.0, -0.6, -0.9), {}});
  scene.add_instance({ball, paint(scene, blue), at(0.2, 1.1, 0.4), {}});
  return scene;
}

Scene large() {
  Scene scene;
  scene.add(quad({-1, -1, 0.1f}, {1, -1, 0.1f}, {1, 1, -0.1f}, {-1, 1, -0.1f}), glm::dmat4(1.0),
            paint(scene, red));
  scene.add(quad({0.1f, -1, 1}, {0.1f, -1, -1}, {-0.1f, 1, -1}, {-0.1f, 1, 1}), glm::dmat4(1.0),
            paint(scene, green));
  scene.add(quad({-1, 0.1f, 1}, {1, -0.1f, 1}, {1, -0.1f, -1}, {-1, 0.1f, -1}), glm::dmat4(1.0),
            paint(scene, blue));
  return scene;
}

Scene room() {
  Scene scene = solids();
  scene.add(shapes::cube(3.4f), at(0.1, 0.8, 0.1), paint(scene, green));
  return scene;
}

Scene not_finite() {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Scene scene;
  // A sheet of 3 x 3 vertices; the ones spoilt take their triangles away, and nothing else.
  scene.add(
      triangles({{-1, -1, 0},
                 {0, -1, 0},
                 {1, -1, 0},
                 {-1, 0, 0},
                 {0, 0, 0.3f},
                 {1, 0, nan},
                 {-1, 1, 0},
                 {0, 1, 0},
                 {infinity, 1, 0}},
                {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}}),
      glm::dmat4(1.0), paint(scene, red));
  // Huge, but finite: a wedge that leaves the picture on the right. Then triangles without area.
  scene.add(triangles({{0.2f, 0.5f, -0.2f}, {3e38f, 3e37f, 0.0f}, {3e38f, -3e37f, 0.0f}, {0.5f, 0.5f, 0.5f}},
                      {{0, 1, 2}, {0, 0, 3}, {3, 3, 3}, {0, 3, 0}}),
            glm::dmat4(1.0), paint(scene, green));
  scene.add(quad({0.3f, -0.8f, 0.2f}, {0.9f, -0.8f, 0.2f}, {0.9f, -0.2f, -0.3f}, {0.3f, -0.2f, -0.3f}),
            glm::dmat4(1.0), paint(scene, blue));
  return scene;
}

Scene transparent() {
  Scene scene;
  scene.add(shapes::sphere(0.4f, 24, 12), glm::dmat4(1.0), paint(scene, yellow));
  scene.add(quad({-1, -0.7f, 0.7f}, {1, -0.7f, -0.7f}, {1, 0.7f, -0.7f}, {-1, 0.7f, 0.7f}), glm::dmat4(1.0),
            paint(scene, red, 0.5f));
  const Mesh sheet = quad({-1, -0.6f, -0.6f}, {1, -0.6f, 0.6f}, {1, 0.6f, 0.6f}, {-1, 0.6f, -0.6f});
  scene.add(sheet, glm::dmat4(1.0), paint(scene, blue, 0.4f));
  scene.add(sheet, glm::dmat4(1.0), paint(scene, green, 0.25f));  // a tie: the blue one lies above
  scene.add(shapes::cube(1.1f), glm::dmat4(1.0), paint(scene, {0.7f, 0.7f, 0.7f}, 0.2f));
  return scene;
}

Scene from_text() {
  constexpr std::string_view text =
      "v 0.1 0.2 0.30000000000000004\nv 1.00000017881393432617187499 0.33333333333333333333333333 -0.7\n"
      "v 0.5000000298023223876953125 1.1754943508222875e-38 9.9999999999999999999e-1\n"
      "v -7.0064923216240853546186479164495e-46 1 -1.25e-1\n"
      "v 16777217e-7 -0.95 8.5e-1\nf 1 2 3\nf 2 4 3\nf 1 3 5 4\n";
  return load_scene_from_memory(std::as_bytes(std::span(text)), "numbers.obj");
}

Scene lit() {
  Scene scene;
  Mesh ring = shapes::torus(0.75f, 0.3f, 32, 16);
  std::vector<glm::vec4> colours;
  for (const glm::vec3& p : ring.positions) {
    colours.emplace_back(0.5f + 0.45f * p.x, 0.5f + 1.2f * p.y, 0.5f + 0.45f * p.z, 1.0f);
  }
  ring.colours = std::move(colours);
  Material shiny;
  shiny.base_colour = {1.0f, 1.0f, 1.0f};
  shiny.specular = glm::vec3(0.4f);
  shiny.shininess = 120.0f;
  scene.add(ring, glm::dmat4(1.0), scene.add_material(shiny));
  scene.add(shapes::icosphere(0.35f, 2), at(0.0, 0.1, 0.0), scene.add_material(shiny));
  scene.directional_lights.push_back({{-0.3, -1.0, -0.5}, {0.35f, 0.3f, 0.2f}});
  scene.point_lights.push_back({{1.5, 0.8, 1.0}, {0.1f, 0.25f, 0.5f}});
  return scene;
}

Scene lines() {
  Scene scene;
  add_solids(scene, {0.0, 0.0, 0.0});
  Mesh cage = shapes::icosahedron(1.6f);
  std::vector<glm::uvec2> segments;
  for (const glm::uvec3& t : cage.triangles) segments.insert(segments.end(), {{t.x, t.y}, {t.z, t.y}});
  cage.triangles = {};
  cage.normals = {};
  cage.segments = std::move(segments);
  scene.add(cage, glm::dmat4(1.0), paint(scene, yellow));
  Mesh cloud = shapes::icosphere(1.1f, 3);
  std::vector<std::uint32_t> points;
  for (std::uint32_t i = 0; i < cloud.positions.size(); ++i) points.push_back(i);
  cloud.triangles = {};
  cloud.points = std::move(points);
  scene.add(cloud, glm::dmat4(1.0), paint(scene, blue));
  return scene;
}

Scene far_away() {
  Scene scene;
  add_solids(scene, {1e6, -1e6, 1e6});
  return scene;
}

Scene wide() {
  Scene scene;
  for (int i = 0; i < 8; ++i) {
    const double x = 256.0 * i - 1024.0;
    scene.add(shapes::stairs(20),
              placed({0.0, 0.0, -1.0}, {0.0, 0.2, 0.0}, {40.0, 0.0, 0.0}, {x + 128.0, -0.5, 0.0}),
              paint(scene, i % 2 == 0 ? blue : yellow));
    scene.add(shapes::letter_f(),
              placed({60.0, 0.0, 0.0}, {0.0, 0.8, 0.0}, {0.0, 0.0, 1.0}, {x + 50.0, 0.0, 0.5}),
              paint(scene, red));
  }
  return scene;
}

}  // namespace golden
