#include "shading/surface_rows.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "shading/shade.hpp"
#include "shading/texture_rows.hpp"
#include "shading/triangle_planes.hpp"
#include "test_cameras.hpp"

using namespace velum;

namespace {

constexpr Viewport viewport{200, 160};
constexpr int first_x = 40;

template <typename T>
bool same(T a, T b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0 || (a != a && b != b);
}

template <typename Vector, typename Scalar>
bool same3(const Vector& v, const Scalar (&planes)[3][row_room], std::size_t i) {
  return same(v.x, planes[0][i]) && same(v.y, planes[1][i]) && same(v.z, planes[2][i]);
}

/// One triangle, with vertex normals and colours; sometimes far away, tiny, or with opposite normals.
Mesh random_mesh(Random& random) {
  const double scales[] = {1.0, 1.0, 1.0, 1e-3, 30.0};
  const double scale = scales[random.below(5)];
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> colours;
  for (int i = 0; i < 3; ++i) {
    positions.emplace_back(random_vector(random, -2, 2) * scale);
    normals.emplace_back(random_vector(random, -1, 1));
    colours.emplace_back(glm::vec3(random_vector(random, 0, 1)), static_cast<float>(random.uniform()));
  }
  if (random.below(4) == 0) normals[1] = normals[2] = -normals[0];
  const double spreads[] = {0.0, 1e-6, 0.01, 1.0, 1.0, 30.0, 1e12};
  const double spread = spreads[random.below(7)];
  std::vector<glm::vec2> coordinates;
  for (int i = 0; i < 3; ++i) coordinates.emplace_back(random_vector(random, -spread, spread));
  Mesh mesh;
  mesh.texture_coordinates = std::move(coordinates);
  mesh.positions = std::move(positions);
  mesh.triangles = {glm::uvec3(0, 1, 2)};
  mesh.normals = std::move(normals);
  mesh.colours = std::move(colours);
  return mesh;
}

std::shared_ptr<const Texture> random_texture(Random& random) {
  Image<Rgba8> picture(1 + random.below(70), 1 + random.below(40));
  const bool is_opaque = random.below(2) == 0;
  const auto code = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      picture.at(x, y) = {code(), code(), code(),
                          is_opaque || random.below(3) == 0 ? std::uint8_t{255} : code()};
    }
  }
  return std::make_shared<const Texture>(picture.view());
}

Material random_material(Random& random) {
  const float shininesses[] = {0.0f, 1.0f, 32.0f, 37.5f, 1e6f, 1e-30f};
  Material material;
  material.diffuse = random_vector(random, 0, 1);
  material.ambient = random_vector(random, 0, 1);
  material.specular = random.below(4) == 0 ? glm::dvec3(0.0) : random_vector(random, 0, 1);
  material.shininess = shininesses[random.below(6)];
  if (random.below(4) == 0) return material;
  material.texture = random_texture(random);
  const TextureWrap wraps[] = {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::mirror};
  material.texture_mapping.wrap = {wraps[random.below(3)], wraps[random.below(3)]};
  material.texture_mapping.scale = random_vector(random, -2, 2);
  material.texture_mapping.offset = random_vector(random, -1, 1);
  return material;
}

Lighting random_lighting(Random& random) {
  Lighting lighting;
  lighting.ambient = random_vector(random, 0, 0.3);
  for (int i = random.below(3); i > 0; --i) {
    const glm::dvec3 direction = glm::normalize(random_vector(random, -1, 1));
    lighting.directional.push_back({direction, glm::vec3(random_vector(random, 0, 1))});
  }
  for (int i = random.below(3); i > 0; --i)
    lighting.points.push_back({random_vector(random, -4, 4), glm::vec3(random_vector(random, 0, 9))});
  return lighting;
}

LightingWork work_of(const Lighting& lighting, const Material& material, std::vector<RowLight>& lights) {
  for (const DirectionalLight& light : lighting.directional) {
    const glm::dvec3 to = -light.direction;
    lights.push_back({{to.x, to.y, to.z}, {light.radiance.x, light.radiance.y, light.radiance.z}, false});
  }
  for (const PointLight& light : lighting.points) {
    const glm::dvec3 at = light.position;
    lights.push_back({{at.x, at.y, at.z}, {light.radiance.x, light.radiance.y, light.radiance.z}, true});
  }
  LightingWork work{};
  work.lights = lights.data();
  work.light_count = lights.size();
  for (int c = 0; c < 3; ++c) {
    work.ambient[c] = lighting.ambient[c] * material.ambient[c];
    work.diffuse[c] = material.diffuse[c];
    work.specular[c] = material.specular[c];
  }
  work.shininess = static_cast<double>(material.shininess);
  return work;
}

struct Case {
  TriangleView triangle;
  Lighting lighting;
  int y;
  std::size_t begin, end;
};

/// Interpolates, and lays the material's texture over it.
void fill(const Case& c, const TrianglePlanes& planes, Isa isa, SurfaceRow& row) {
  const Material& material = *c.triangle.material;
  const SurfaceNeeds needs{true, true, true, true, material.texture != nullptr};
  interpolate_surface_kernel(isa)({&planes, first_x, c.y, c.begin, c.end, needs, &row});
  if (!needs.texture) return;
  const RowTexture texture = row_texture_of(material, c.triangle.texture_filter);
  texture_row_kernel(isa)({&planes, &texture, c.begin, c.end, &row});
}

bool same_colour(const glm::vec4& colour, const SurfaceRow& row, std::size_t i) {
  return same(colour.x, row.colour[0][i]) && same(colour.y, row.colour[1][i]) &&
         same(colour.z, row.colour[2][i]) && same(colour.w, row.colour[3][i]);
}

/// Lit once per triangle or at the vertices, under the texture.
void check_lit_before(const Case& c, Shading shading, Isa isa) {
  CAPTURE(name_of(isa));
  const LitTriangle lit = light_triangle(shading, c.lighting, c.triangle);
  const std::array<glm::vec4, 3> faces{lit.face, lit.face, lit.face};
  const std::array<glm::vec3, 3> highlights{lit.face_highlight, lit.face_highlight, lit.face_highlight};
  const bool is_flat = shading == Shading::flat;
  const TrianglePlanes planes =
      planes_of(c.triangle, is_flat ? faces : lit.corners, is_flat ? &highlights : &lit.corner_highlights);
  const auto row = std::make_unique<SurfaceRow>();
  fill(c, planes, isa, *row);
  int different = 0;
  for (std::size_t i = c.begin; i < c.end; ++i) {
    const SurfacePoint point = surface_point(c.triangle, first_x + static_cast<int>(i), c.y, 0.5f);
    different += !same_colour(shade(shading, c.lighting, lit, point, {}), *row, i);
  }
  CHECK(different == 0);
}

void check(const Case& c, Isa isa) {
  CAPTURE(name_of(isa));
  const TrianglePlanes planes = planes_of(c.triangle, c.triangle.colours);
  const auto row = std::make_unique<SurfaceRow>();
  fill(c, planes, isa, *row);
  std::vector<SurfacePoint> points;
  int different = 0;
  for (std::size_t i = c.begin; i < c.end; ++i) {
    points.push_back(surface_point(c.triangle, first_x + static_cast<int>(i), c.y, 0.5f));
    const SurfacePoint& point = points.back();
    const bool is_same =
        same3(point.position, row->position, i) && same3(point.to_viewer, row->to_viewer, i) &&
        same3(point.barycentric, row->barycentric, i) && same3(point.shading_normal, row->normal, i) &&
        same(point.metric_depth, row->metric_depth[i]) && same_colour(point.colour, *row, i);
    different += !is_same;
  }
  CHECK(different == 0);

  std::vector<RowLight> lights;
  LightingWork work = work_of(c.lighting, *c.triangle.material, lights);
  work.begin = c.begin;
  work.end = c.end;
  work.row = row.get();
  const float beyond = row->colour[0][c.end];
  light_row_kernel(isa)(work);
  CHECK(same(beyond, row->colour[0][c.end]));
  different = 0;
  for (std::size_t i = c.begin; i < c.end; ++i) {
    const SurfacePoint& p = points[i - c.begin];
    const glm::vec4 lit =
        blinn_phong(c.lighting, *p.material, p.position, p.shading_normal, p.to_viewer, p.colour);
    different += !same_colour(lit, *row, i);
  }
  CHECK(different == 0);
}

void check_random(Random& random) {
  Scene scene;
  glm::dmat4 placed(random_rotation(random));
  placed[3] = glm::dvec4(random_vector(random, -1, 1), 1.0);
  scene.add(random_mesh(random), placed, scene.add_material(random_material(random)));
  const Lighting lighting = random_lighting(random);
  const TextureFilter filters[] = {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear,
                                   TextureFilter::trilinear};
  for (TestCamera camera : random_cameras(random, viewport)) {
    camera.viewer.texture_filter = filters[random.below(4)];
    const TriangleView triangle = view_of(scene, camera);
    if (triangle.determinant == 0.0) continue;
    const auto begin = static_cast<std::size_t>(random.below(most_row_pixels));
    const std::size_t end = begin + 1 + static_cast<std::size_t>(random.below(int(most_row_pixels - begin)));
    for (const Isa isa : available_isas()) {
      if (isa == Isa::reference) continue;
      const Case c{triangle, lighting, random.below(viewport.height), begin, end};
      check(c, isa);
      check_lit_before(c, random.below(2) == 0 ? Shading::flat : Shading::gouraud, isa);
    }
  }
}

}  // namespace

TEST_CASE(
    "surfaces along a row, their textures and light: the vector kernels give the scalar functions' bits") {
  Random random{31};
  for (int i = 0; i < 300; ++i) check_random(random);
}

TEST_CASE("[long] surfaces along a row and their light: many triangles") {
  Random random{32};
  for (int i = 0; i < 30000; ++i) check_random(random);
}

TEST_CASE("a plane's horizon along a row: the nearest vertex, as in barycentrics_at()") {
  // Seen edge-on but for its last bits, and a vertex so far that squares overflow.
  Random random{33};
  for (const float size : {1e-20f, 1e15f, 3e37f}) {
    Scene scene;
    Mesh mesh = triangle_mesh({0, 0, -5}, {size, size * 1e-7f, -5}, {-size, size, size});
    scene.add(mesh);
    for (const TestCamera& camera : random_cameras(random, viewport)) {
      const TriangleView triangle = view_of(scene, camera);
      if (triangle.determinant == 0.0) continue;
      for (const Isa isa : available_isas()) {
        if (isa != Isa::reference) check({triangle, random_lighting(random), 80, 0, most_row_pixels}, isa);
      }
    }
  }
}
