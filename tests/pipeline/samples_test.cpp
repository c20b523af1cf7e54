// Anti-aliasing by samples: what it leaves alone, and what the colours are.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <velum/velum.hpp>

#include "pipeline/memory_need.hpp"
#include "small_scenes.hpp"
#include "visibility/sample_positions.hpp"

using namespace velum;
using velum::test::meeting_solids;
using velum::test::moved;

namespace {

RenderSettings settings_of(int samples, int width = 96, int height = 72) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.samples = samples;
  settings.threads = 1;
  return settings;
}

/// Solids, glass, segments and points.
Scene everything() {
  Scene scene = meeting_solids();
  Material glass;
  glass.alpha = 0.4f;
  scene.add(shapes::sphere(), moved({0.2, 0.5, 1.0}), scene.add_material(glass));
  Mesh lines;
  lines.positions = {glm::vec3(-1, -1, 1), glm::vec3(1, 1.1f, 0.5f), glm::vec3(0.9f, -0.8f, 1),
                     glm::vec3(-0.7f, 0.9f, 1.2f)};
  lines.segments = {glm::uvec2(0, 1), glm::uvec2(2, 3)};
  lines.points = {1, 2, 3};
  scene.add(lines);
  return scene;
}

Camera camera_of(const Scene& scene, const RenderSettings& settings) {
  return velum::test::camera_of(scene, "perspective", settings);
}

template <typename T>
bool same_rows(const Image<T>& a, const Image<T>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y) {
    if (std::memcmp(a.row(y), b.row(y), sizeof(T) * static_cast<std::size_t>(a.width())) != 0) return false;
  }
  return true;
}

bool same_but_colour(const Picture& a, const Picture& b) {
  return same_rows(a.depth, b.depth) && same_rows(a.metric_depth, b.metric_depth) &&
         same_rows(a.normal, b.normal) && same_rows(a.object_id, b.object_id) &&
         same_rows(a.triangle_id, b.triangle_id);
}

/// Opaque or translucent rectangles in a picture whose pixels are units, x right and y down; a later one is
/// farther.
struct Sheet {
  double left, top, right, bottom;
  glm::vec4 colour;  ///< linear, straight alpha
};

Scene scene_of(const std::vector<Sheet>& sheets) {
  Scene scene;
  float z = 0.5f;
  for (const Sheet& sheet : sheets) {
    const auto corner = [&](double x, double y) {
      return glm::vec3(static_cast<float>(x), static_cast<float>(y), z);
    };
    Mesh mesh;
    mesh.positions = {corner(sheet.left, sheet.top), corner(sheet.right, sheet.top),
                      corner(sheet.right, sheet.bottom), corner(sheet.left, sheet.bottom)};
    mesh.triangles = {glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)};
    Material material;
    material.base_colour = glm::vec3(sheet.colour);
    material.alpha = sheet.colour.a;
    scene.add(mesh, glm::dmat4(1.0), scene.add_material(material));
    z += 0.01f;
  }
  return scene;
}

/// World x, y are pixels, z is the canonical depth.
Camera pixel_camera(int width, int height) {
  glm::dmat4 clip(1.0);
  clip[0][0] = 2.0 / width;
  clip[1][1] = -2.0 / height;
  clip[3] = {-1.0, 1.0, 0.0, 1.0};
  return Camera::from_clip_matrix(clip, DepthRange::zero_to_one);
}

RenderSettings unlit(int samples, int width, int height) {
  RenderSettings settings = settings_of(samples, width, height);
  settings.shader = [](const SurfacePoint& point) {
    return glm::vec4(point.material->base_colour, point.material->alpha);
  };
  return settings;
}

/// The same camera with the picture moved so that a sample comes to lie on the pixels' centres.
Camera moved_to(const SamplePosition& sample, const Camera& camera, const RenderSettings& settings) {
  const double aspect = static_cast<double>(settings.width) / settings.height;
  glm::dmat4 m = camera.viewing_transform(aspect).clip_from_world();
  for (int i = 0; i < 4; ++i) {
    m[i][0] -= m[i][3] * 2.0 * sample.x / 256.0 / settings.width;
    m[i][1] += m[i][3] * 2.0 * sample.y / 256.0 / settings.height;
  }
  return Camera::from_clip_matrix(m, DepthRange::zero_to_one);
}

/// The oracle: the mean of so many pictures without samples, premultiplied in linear light.
Image<Rgba8> mean_of_pictures(const Scene& scene, const Camera& camera, RenderSettings settings) {
  const auto positions = sample_positions(settings.samples);
  settings.samples = 1;
  Image<glm::vec4> sum(settings.width, settings.height);
  for (const SamplePosition& sample : positions) {
    const Picture picture = render(scene, moved_to(sample, camera, settings), settings);
    for (int y = 0; y < settings.height; ++y) {
      for (int x = 0; x < settings.width; ++x) {
        const glm::vec4 c = linear_from_srgb(picture.colour.at(x, y));
        sum.at(x, y) += glm::vec4(glm::vec3(c) * c.a, c.a);
      }
    }
  }
  Image<Rgba8> mean(settings.width, settings.height);
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) {
      const glm::vec4 c = sum.at(x, y) / static_cast<float>(positions.size());
      const glm::vec3 straight = c.a > 0.0f ? glm::vec3(c) / c.a : glm::vec3(0.0f);
      mean.at(x, y) = srgb_from_linear(glm::vec4(straight, c.a));
    }
  }
  return mean;
}

/// Pixels that differ by more than `codes` in a channel (colour premultiplied in effect: not where alpha is
/// small).
int pixels_apart(const Image<Rgba8>& a, const Image<Rgba8>& b, int codes) {
  int apart = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const Rgba8 p = a.at(x, y), q = b.at(x, y);
      const int allowed = p.a < 128 ? 4 * codes : codes;
      apart += std::abs(p.r - q.r) > allowed || std::abs(p.g - q.g) > allowed ||
               std::abs(p.b - q.b) > allowed || std::abs(p.a - q.a) > codes;
    }
  }
  return apart;
}

int pixels_that_differ(const Image<Rgba8>& a, const Image<Rgba8>& b) {
  return pixels_apart(a, b, 0);
}

}  // namespace

TEST_CASE("depths, ids and normals are those of the pixel centres, with any number of samples") {
  const Scene scene = everything();
  for (const bool wireframe : {false, true}) {
    RenderSettings settings = settings_of(1);
    settings.wireframe = wireframe;
    settings.line_width = 1.5f;
    const Camera camera = camera_of(scene, settings);
    const Picture without = render(scene, camera, settings);
    for (const int samples : {4, 8, 16}) {
      settings.samples = samples;
      const Picture with = render(scene, camera, settings);
      CHECK(same_but_colour(with, without));
      CHECK(pixels_that_differ(with.colour, without.colour) > 100);
      CHECK(with.counters.triangles == without.counters.triangles);
    }
  }
}

TEST_CASE("samples: the same bytes with every method, instruction set, executor and number of threads") {
  const Scene scene = everything();
  for (const bool wireframe : {false, true}) {
    RenderSettings settings = settings_of(8, 150, 110);
    settings.wireframe = wireframe;
    const Camera camera = camera_of(scene, settings);
    const Picture expected = render(scene, camera, settings);
    settings.visibility = VisibilityMethod::scanline;
    CHECK(same_rows(render(scene, camera, settings).colour, expected.colour));
    settings.visibility = VisibilityMethod::zbuffer;
    for (const Isa isa : available_isas()) {
      settings.isa = isa;
      CHECK(same_rows(render(scene, camera, settings).colour, expected.colour));
    }
    settings.isa = Isa::best;
    for (const ExecutorKind kind : {ExecutorKind::tbb, ExecutorKind::std_thread, ExecutorKind::serial}) {
      for (const int threads : {2, 7}) {
        settings.executor = kind;
        settings.threads = threads;
        const Picture actual = render(scene, camera, settings);
        CHECK(same_rows(actual.colour, expected.colour));
        CHECK(std::memcmp(&actual.counters, &expected.counters, sizeof(Counters)) == 0);
      }
    }
  }
}

TEST_CASE("samples: a crop and the colour alone equal the same pixels of the whole picture") {
  const Scene scene = everything();
  RenderSettings settings = settings_of(4);
  settings.wireframe = true;
  const Camera camera = camera_of(scene, settings);
  const Picture whole = render(scene, camera, settings);
  Image<Rgba8> alone(96, 72);
  Renderer().render_into(scene, camera, settings, {.colour = alone.view()});
  CHECK(same_rows(alone, whole.colour));
  settings.crop = Rect{13, 9, 50, 41};
  const Picture part = render(scene, camera, settings);
  int different = 0;
  for (int y = 0; y < 41; ++y) {
    for (int x = 0; x < 50; ++x)
      different += !(part.colour.at(x, y) == whole.colour.at(x + 13, y + 9)) ||
                   part.depth.at(x, y) != whole.depth.at(x + 13, y + 9);
  }
  CHECK(different == 0);
}

TEST_CASE("samples: a picture too large for one band equals the crops it is made of") {
  const Scene scene = everything();
  RenderSettings settings = settings_of(16, 1600, 320);
  settings.shading = Shading::flat;
  const Rect rect{0, 0, settings.width, settings.height};
  const int height = sample_band_height(scene, settings, rect);
  REQUIRE(height < settings.height);
  REQUIRE(height % 64 == 0);
  const Camera camera = camera_of(scene, settings);
  const Picture whole = render(scene, camera, settings);
  settings.crop = Rect{0, height - 20, settings.width, 40};
  const Picture across = render(scene, camera, settings);
  int different = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < settings.width; ++x)
      different += !(across.colour.at(x, y) == whole.colour.at(x, y + height - 20));
  }
  CHECK(different == 0);
  CHECK(whole.counters.triangles ==
        scene.primitive_count() - 5);  // counted once; without segments and points
}

TEST_CASE("samples: a white and black edge through the middle of pixels is resolved in linear light") {
  const Scene scene = scene_of({{1.5, 0, 4, 4, {1, 1, 1, 1}}, {0, 0, 4, 4, {0, 0, 0, 1}}});
  for (const int samples : {4, 8, 16}) {
    const Picture picture = render(scene, pixel_camera(4, 4), unlit(samples, 4, 4));
    CHECK(picture.colour.at(0, 2) == Rgba8{0, 0, 0, 255});
    CHECK(picture.colour.at(1, 2) == Rgba8{188, 188, 188, 255});  // sRGB of linear 0.5
    CHECK(picture.colour.at(2, 2) == Rgba8{255, 255, 255, 255});
  }
}

TEST_CASE(
    "samples: over nothing an edge is transparent in proportion; over a background it is mixed with it") {
  const Scene scene = scene_of({{0, 1.5, 4, 4, {1, 0.5f, 0, 1}}});
  RenderSettings settings = unlit(4, 4, 4);
  const Rgba8 colour = render(scene, pixel_camera(4, 4), settings).colour.at(1, 1);
  CHECK(colour == Rgba8{255, 188, 0, 128});
  settings.background = {0, 0, 255, 255};
  CHECK(render(scene, pixel_camera(4, 4), settings).colour.at(1, 1) ==
        srgb_from_linear(glm::vec4(0.5f, 0.25f, 0.5f, 1.0f)));
}

TEST_CASE("samples: behind a translucent edge each sample sees its own layers") {
  // A pane of 50 % ends in the middle of column 1; behind it red ends in the middle of row 1, then green.
  const Scene scene =
      scene_of({{0, 0, 1.5, 4, {1, 1, 1, 0.5f}}, {0, 0, 4, 1.5, {1, 0, 0, 1}}, {0, 0, 4, 4, {0, 1, 0, 1}}});
  for (const int samples : {4, 8, 16}) {
    const Picture picture = render(scene, pixel_camera(4, 4), unlit(samples, 4, 4));
    CHECK(picture.colour.at(0, 0) == srgb_from_linear(glm::vec4(1.0f, 0.5f, 0.5f, 1)));
    CHECK(picture.colour.at(1, 0) == srgb_from_linear(glm::vec4(1.0f, 0.25f, 0.25f, 1)));
    CHECK(picture.colour.at(0, 1) == srgb_from_linear(glm::vec4(0.75f, 0.75f, 0.5f, 1)));
    CHECK(picture.colour.at(3, 1) == srgb_from_linear(glm::vec4(0.5f, 0.5f, 0.0f, 1)));
    // Both edges: a quarter of the samples each, as the patterns have it.
    int pane_red = 0, pane_green = 0, red = 0, green = 0;
    for (const SamplePosition& sample : sample_positions(samples)) {
      (sample.x < 0 ? (sample.y < 0 ? pane_red : pane_green) : (sample.y < 0 ? red : green)) += 1;
    }
    const glm::vec3 sum = static_cast<float>(pane_red) * glm::vec3(1, 0.5f, 0.5f) +
                          static_cast<float>(pane_green) * glm::vec3(0.5f, 1, 0.5f) +
                          static_cast<float>(red) * glm::vec3(1, 0, 0) +
                          static_cast<float>(green) * glm::vec3(0, 1, 0);
    CHECK(picture.colour.at(1, 1) == srgb_from_linear(glm::vec4(sum / static_cast<float>(samples), 1.0f)));
  }
}

TEST_CASE("samples: the layer limit holds at edges as elsewhere") {
  const Scene scene = scene_of({{0, 0, 1.5, 4, {1, 1, 1, 0.5f}}, {0, 0, 4, 4, {0, 1, 0, 1}}});
  RenderSettings settings = unlit(4, 4, 4);
  settings.layers = 1;
  const Picture picture = render(scene, pixel_camera(4, 4), settings);
  CHECK(picture.colour.at(0, 0) == srgb_from_linear(glm::vec4(1, 1, 1, 0.5f)));
  CHECK(picture.colour.at(1, 0).a == 191);  // half of it opaque, half of it half
}

TEST_CASE("samples: the mean of that many pictures, each moved to its sample") {
  Scene solids = meeting_solids();
  Scene glass = everything();
  Random random{5};
  for (int i = 0; i < 12; ++i) {
    Material material;
    const auto f = [&] { return static_cast<float>(random.uniform()); };
    material.base_colour = {f(), f(), f()};
    material.alpha = 0.2f + 0.7f * f();
    Mesh mesh;
    mesh.positions = {{f(), f(), f()}, {f(), f(), f()}, {f(), f(), f()}};
    mesh.triangles = {glm::uvec3(0, 1, 2)};
    glass.add(mesh, glm::dmat4(1.0), glass.add_material(material));
  }
  for (const Scene* scene : {&solids, &glass}) {
    for (const int samples : {4, 16}) {
      const RenderSettings settings = unlit(samples, 96, 72);
      const Camera camera = camera_of(*scene, settings);
      const Picture picture = render(*scene, camera, settings);
      CHECK(pixels_apart(picture.colour, mean_of_pictures(*scene, camera, settings), 2) <= 2);
    }
  }
}

TEST_CASE("samples: the wireframe too is the mean of that many pictures") {
  const Scene scene = meeting_solids();
  RenderSettings settings = unlit(8, 96, 72);
  settings.wireframe = true;
  const Camera camera = camera_of(scene, settings);
  const Picture picture = render(scene, camera, settings);
  CHECK(pixels_apart(picture.colour, mean_of_pictures(scene, camera, settings), 2) <= 4);
}

TEST_CASE("samples: where all of them see one primitive, colours are those without samples") {
  Scene scene;
  scene.add(shapes::cube());
  Material glass;
  glass.alpha = 0.4f;
  scene.add(shapes::cube(), moved({1.3, 0.3, 0.2}), scene.add_material(glass));
  RenderSettings settings = settings_of(1, 160, 120);
  const Camera camera = camera_of(scene, settings);
  const Picture without = render(scene, camera, settings);
  settings.samples = 16;
  const Picture with = render(scene, camera, settings);
  int inside = 0, different = 0;
  for (int y = 1; y < 119; ++y) {
    for (int x = 1; x < 159; ++x) {
      bool is_inside = true;
      const std::uint32_t id = without.triangle_id.at(x, y);
      for (int i = 0; i < 9; ++i)
        is_inside = is_inside && without.triangle_id.at(x - 1 + i % 3, y - 1 + i / 3) == id;
      if (!is_inside || without.object_id.at(x, y) != 0) continue;  // 1 is the glass
      ++inside;
      different += !(with.colour.at(x, y) == without.colour.at(x, y));
    }
  }
  CHECK(inside > 1000);
  CHECK(different == 0);
}

TEST_CASE("samples: a primitive is shaded once per pixel, within itself") {
  const Scene scene = scene_of({{0.6, 0.6, 2.3, 2.9, {1, 1, 1, 1}}});
  RenderSettings settings = settings_of(4, 4, 4);
  int calls = 0, outside = 0;
  settings.shader = [&](const SurfacePoint& point) {
    ++calls;
    const glm::dvec3 p = point.position;
    outside += p.x < 0.6 || p.x > 2.3 || p.y < 0.6 || p.y > 2.9 || static_cast<int>(p.x) != point.x ||
               static_cast<int>(p.y) != point.y;
    return glm::vec4(1.0f);
  };
  const Picture picture = render(scene, pixel_camera(4, 4), settings);
  CHECK(outside == 0);
  CHECK(calls == static_cast<int>(picture.counters.pixels_shaded));
  CHECK(calls >= 9);  // its pixels; on its diagonal two primitives meet
  CHECK(calls <= 9 + 4);
}

TEST_CASE("numbers of samples that no pattern has are errors that say so") {
  const Scene scene = meeting_solids();
  for (const int samples : {0, 2, 3, 5, 32, -4}) {
    const RenderSettings settings = settings_of(samples);
    CHECK_THROWS_WITH_AS(render(scene, camera_of(scene, settings), settings), doctest::Contains("4, 8 or 16"),
                         Error);
  }
}

TEST_CASE("samples count as memory") {
  const Scene scene = meeting_solids();
  RenderSettings settings = settings_of(1, 1000, 1000);
  const Rect rect{0, 0, 1000, 1000};
  const std::uint64_t without = buffer_bytes(scene, settings, rect);
  settings.samples = 16;
  CHECK(buffer_bytes(scene, settings, rect) >= without + 16u * 8u * 1000000u);
  settings.memory_ceiling = without * 3;
  CHECK_THROWS_AS(render(scene, camera_of(scene, settings), settings), Error);
}
