#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <glm/ext/matrix_transform.hpp>
#include <limits>
#include <span>
#include <velum/velum.hpp>

#include "random.hpp"

using namespace velum;

namespace {

RenderSettings size(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  return settings;
}

/// One unit is one pixel of a picture `pixels` square; (0, 0) is its middle; depths 1 … 9.
Camera plan(int pixels) {
  ParallelWindow window;
  window.height = pixels;
  return Camera::parallel({}, window, 1.0, 9.0);
}

Camera eye() {
  return Camera::perspective({}, {}, 1.0, 9.0);
}

Mesh line(const glm::vec3& a, const glm::vec3& b) {
  Mesh mesh;
  mesh.positions = {a, b};
  mesh.segments = {glm::uvec2(0, 1)};
  return mesh;
}

int count(const Picture& picture, std::uint32_t primitive) {
  int pixels = 0;
  for (int y = 0; y < picture.triangle_id.height(); ++y) {
    for (int x = 0; x < picture.triangle_id.width(); ++x) pixels += picture.triangle_id.at(x, y) == primitive;
  }
  return pixels;
}

bool same(const Picture& a, const Picture& b) {
  bool equal = true;
  for (int y = 0; y < a.colour.height(); ++y) {
    const auto row_bytes = [&](const auto& image) {
      return sizeof(*image.row(y)) * static_cast<std::size_t>(a.colour.width());
    };
    equal = equal && std::memcmp(a.colour.row(y), b.colour.row(y), row_bytes(a.colour)) == 0 &&
            std::memcmp(a.depth.row(y), b.depth.row(y), row_bytes(a.depth)) == 0;
  }
  return equal;
}

Scene cloud(int points) {
  Random random{77};
  Mesh mesh;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  for (int i = 0; i < points; ++i) {
    positions.emplace_back(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-9, -2));
    indices.push_back(static_cast<std::uint32_t>(i));
  }
  mesh.positions = positions;
  mesh.points = indices;
  Scene scene;
  scene.add(mesh);
  return scene;
}

}  // namespace

TEST_CASE("segments and points have ids behind the triangles', their own colour, depth and no normal") {
  Scene scene;
  Mesh mesh;
  mesh.positions = {glm::vec3(-5, 0, -3), glm::vec3(5, 0, -3), glm::vec3(0, 5, -7),
                    glm::vec3(-7.5f, -7.5f, -5)};
  mesh.colours = {glm::vec4(1, 0, 0, 1), glm::vec4(0, 0, 1, 1), glm::vec4(1), glm::vec4(0, 1, 0, 1)};
  mesh.triangles = {glm::uvec3(0, 1, 2)};
  mesh.segments = {glm::uvec2(0, 1)};
  mesh.points = {3u};
  scene.add(mesh);
  Material white;
  white.base_colour = glm::vec3(1.0f);
  scene.set_material(0, white);
  const Picture picture = render(scene, plan(20), size(20, 20));
  CHECK(count(picture, 0) > 10);
  CHECK(count(picture, 1) == 10);
  CHECK(count(picture, 2) == 9);
  CHECK(picture.counters.segments == 1);
  CHECK(picture.counters.points == 1);
  CHECK(picture.colour.at(2, 17) == Rgba8{0, 255, 0, 255});
  CHECK(picture.metric_depth.at(2, 17) == doctest::Approx(5.0));
  CHECK(picture.depth.at(2, 17) == doctest::Approx(0.5));
  CHECK(picture.normal.at(2, 17) == glm::vec3(0.0f));
  CHECK(picture.metric_depth.at(9, 9) == doctest::Approx(3.0));
  CHECK(picture.object_id.at(9, 9) == 0);
}

TEST_CASE("line width and point size are pixels, from 1 to 256") {
  Scene scene;
  scene.add(line({-5, 0, -3}, {5, 0, -3}));
  Mesh point;
  point.positions = {glm::vec3(0, 7, -3)};
  point.points = {0u};
  scene.add(point);
  RenderSettings settings = size(20, 20);
  settings.line_width = 4.0f;
  settings.point_size = 1.0f;
  const Picture picture = render(scene, plan(20), settings);
  CHECK(count(picture, 0) == 40);
  CHECK(count(picture, 1) == 1);
  settings.point_size = 256.0f;
  CHECK(count(render(scene, plan(20), settings), 1) == 400 - 40);  // the line has the same depth: its id wins
  for (const float wrong : {0.5f, 257.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    settings.line_width = wrong;
    CHECK_THROWS_AS(render(scene, plan(20), settings), Error);
  }
}

TEST_CASE("segments are clipped at all six planes, behind the viewer too, and keep their depth") {
  const struct {
    glm::vec3 a, b;
    int pixels;
  } cases[] = {
      {{-50, 0.2f, -3}, {0, 0.2f, -3}, 10},  // left
      {{0, 0.2f, -3}, {50, 0.2f, -3}, 10},   // right
      {{0.2f, -50, -3}, {0.2f, 0, -3}, 10},  // below
      {{0.2f, 0, -3}, {0.2f, 50, -3}, 10},   // above
      {{-4, 0.2f, 3}, {4, 0.2f, -5}, 4},     // in front: from x = 0, where z = -1
      {{-4, 0.2f, -5}, {4, 0.2f, -13}, 4},   // behind: to x = 0, where z = -9
  };
  for (const auto& c : cases) {
    Scene scene;
    scene.add(line(c.a, c.b));
    const Picture picture = render(scene, plan(20), size(20, 20));
    CAPTURE(c.a.x);
    CHECK(picture.counters.segments_clipped == 1);
    CHECK(count(picture, 0) == c.pixels);
    for (int x = 0; x < 20; ++x) {
      if (picture.triangle_id.at(x, 9) != 0 || c.a.y == -50 || c.b.y == 50) continue;
      const double t = (x - 9.5 - double(c.a.x)) / double(c.b.x - c.a.x);
      const double expected = -(double(c.a.z) + t * double(c.b.z - c.a.z));
      CHECK(double(picture.metric_depth.at(x, 9)) == doctest::Approx(expected).epsilon(1e-6));
      CHECK(double(picture.depth.at(x, 9)) == doctest::Approx((expected - 1.0) / 8.0).epsilon(1e-6));
    }
  }
  Scene outside;
  outside.add(line({-4, 0, 3}, {4, 0, 5}));
  Mesh point;
  point.positions = {glm::vec3(0, 0, 2), glm::vec3(std::numeric_limits<float>::infinity(), 0, -3)};
  point.points = {0u, 1u};
  outside.add(point);
  const Picture picture = render(outside, eye(), size(20, 20));
  CHECK(picture.coverage() == 0.0);
  CHECK(picture.counters.segments_outside == 1);
  CHECK(picture.counters.points_outside == 1);
  CHECK(picture.counters.not_finite == 1);
}

TEST_CASE("random segments in perspective: metric depth is that of the line where the pixel sees it") {
  Random random{3};
  int tested = 0;
  for (int i = 0; i < 300; ++i) {
    const auto end = [&] {
      return glm::vec3(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-9, 3));
    };
    const glm::vec3 a = end(), b = end();
    Scene scene;
    scene.add(line(a, b));
    const Picture picture = render(scene, eye(), size(64, 64));
    const glm::dmat4 m = eye().viewing_transform(1.0).clip_from_world();
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        if (picture.triangle_id.at(x, y) != 0) continue;
        // Search the line for the place in this column, then in this row; it is one of the two.
        double best = 1e9;
        for (int axis = 0; axis < 2; ++axis) {
          const glm::dvec4 p = m * glm::dvec4(a, 1.0), q = m * glm::dvec4(b, 1.0);
          const double s = axis == 0 ? (x + 0.5) / 32 - 1 : 1 - (y + 0.5) / 32;
          const double t = (p[axis] - s * p.w) / ((p[axis] - s * p.w) - (q[axis] - s * q.w));
          const double depth = -(double(a.z) + t * (double(b.z) - double(a.z)));
          best = std::min(best, std::abs(double(picture.metric_depth.at(x, y)) / depth - 1.0));
        }
        CHECK(best < 1e-2);  // the columns at the ends may lie 1/256 pixel beyond them
        tested += best < 1e-5;
      }
    }
  }
  CHECK(tested > 3000);
}

TEST_CASE("a crop equals the whole, the order of instances does not matter, renders repeat") {
  Scene scene = cloud(400), turned;
  const Mesh points = scene.meshes()[0];
  scene.add(shapes::house(), glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -6)));
  scene.add(line({-3, -2, -2}, {3, 2, -8}));
  turned.add(line({-3, -2, -2}, {3, 2, -8}));
  turned.add(shapes::house(), glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -6)));
  turned.add(points);
  for (const bool wireframe : {false, true}) {
    RenderSettings settings = size(80, 60);
    settings.wireframe = wireframe;
    settings.line_width = 2.0f;
    const Picture whole = render(scene, eye(), settings);
    CHECK(count(whole, scene.primitive_count() - 1) > 10);
    CHECK(same(whole, render(turned, eye(), settings)));
    settings.visibility = VisibilityMethod::scanline;
    CHECK(same(whole, render(scene, eye(), settings)));
    settings.visibility = VisibilityMethod::zbuffer;
    settings.crop = Rect{23, 11, 40, 30};
    const Picture part = render(scene, eye(), settings);
    bool equal = true;
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        equal = equal && part.colour.at(x, y) == whole.colour.at(x + 23, y + 11) &&
                part.triangle_id.at(x, y) == whole.triangle_id.at(x + 23, y + 11) &&
                part.metric_depth.at(x, y) == whole.metric_depth.at(x + 23, y + 11);
      }
    }
    CHECK(equal);
  }
}

TEST_CASE("picking and explaining a pixel know segments and points") {
  Scene scene;
  scene.add(line({-5, 0, -3}, {5, 0, -5}));
  Mesh point;
  point.positions = {glm::vec3(0.5f, 0.5f, -6)};
  point.points = {0u};
  scene.add(point);
  const RenderSettings settings = size(20, 20);
  const std::optional<PickResult> picked = pick(scene, plan(20), settings, 12, 9);
  REQUIRE(picked);
  CHECK(picked->kind == PrimitiveKind::segment);
  CHECK(picked->object == 0);
  CHECK(picked->barycentrics.y == doctest::Approx(0.75));
  CHECK(picked->position.x == doctest::Approx(2.5));
  CHECK(picked->metric_depth == doctest::Approx(4.5));
  const std::optional<PickResult> below = pick(scene, plan(20), settings, 11, 8);
  REQUIRE(below);
  CHECK(below->kind == PrimitiveKind::point);
  CHECK(below->primitive == 1);
  const PixelExplanation pixel = explain_pixel(scene, plan(20), settings, 10, 9);
  REQUIRE(pixel.fragments.size() == 2);
  CHECK(pixel.fragments[0].place == PrimitivePlace{0, 0, PrimitiveKind::segment});
  CHECK(pixel.fragments[1].place == PrimitivePlace{1, 0, PrimitiveKind::point});
  CHECK(pixel.fragments[1].outcome == FragmentOutcome::farther);
  CHECK_FALSE(pixel.winner);
  CHECK_THROWS_AS(trace_triangle(scene, plan(20), settings, 0), Error);
}

TEST_CASE("every point of a cloud that nothing hides is there, at its depth") {
  const Scene scene = cloud(300);
  RenderSettings settings = size(100, 100);
  settings.point_size = 1.0f;
  const Picture picture = render(scene, eye(), settings);
  const glm::dmat4 m = eye().viewing_transform(1.0).clip_from_world();
  int inside = 0;
  for (const glm::vec3& p : scene.meshes()[0].positions) {
    const glm::dvec4 clip = m * glm::dvec4(p, 1.0);
    if (std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || clip.z < 0 || clip.z > clip.w) continue;
    ++inside;
    // The pixel whose centre is in [-1/2, 1/2) around the snapped place.
    const auto pixel = [](double place) {
      return static_cast<int>(std::ceil(std::floor(place * 256 + 0.5) / 256)) - 1;
    };
    const int x = pixel((clip.x / clip.w + 1) * 50), y = pixel((1 - clip.y / clip.w) * 50);
    if (x < 0 || y < 0) continue;
    CHECK(picture.metric_depth.at(x, y) <= -p.z * 1.00001f);
  }
  CHECK(inside > 100);
  CHECK(picture.counters.points_outside == 300u - static_cast<unsigned>(inside));
}

TEST_CASE("a PLY point cloud loads and draws, lit by its normals where it has them") {
  const auto load = [](const std::string& text) {
    return load_scene_from_memory(std::as_bytes(std::span(text)), "cloud.ply");
  };
  const std::string begin = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n";
  const Scene plain = load(begin + "property float z\nend_header\n-4 0 -3\n4 0 -3\n");
  const Picture unlit = render(plain, plan(20), size(20, 20));
  CHECK(count(unlit, 0) == 9);
  CHECK(count(unlit, 1) == 9);
  const Scene lit =
      load(begin + "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n" +
           "end_header\n-4 0 -3 0 0 1\n4 0 -3 1 0 0\n");
  const Picture picture = render(lit, plan(20), size(20, 20));
  CHECK(picture.normal.at(6, 9) == glm::vec3(0, 0, 1));
  CHECK(picture.colour.at(6, 9).r > picture.colour.at(14, 9).r);
}

TEST_CASE("the wireframe of a cube in front view hides the back edges") {
  Scene scene;
  scene.add(shapes::cube(2.0f), glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -4)));
  RenderSettings settings = size(64, 64);
  settings.shading = Shading::flat;
  const Camera camera = Camera::perspective({}, {}, 1.0, 9.0);
  const Picture plain = render(scene, camera, settings);
  settings.wireframe = true;
  const Picture wired = render(scene, camera, settings);
  const Rect box = plain.bounding_box();
  int ink = 0, inner = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      if (wired.colour.at(x, y) == plain.colour.at(x, y)) continue;
      ++ink;
      const bool at_border = x <= box.left || x >= box.right() - 1 || y <= box.top || y >= box.bottom() - 1;
      const bool on_diagonal = std::abs((x - box.left) - (y - box.top)) <= 1 ||
                               std::abs((x - box.left) - (box.bottom() - 1 - y)) <= 1;
      inner += !at_border && !on_diagonal;  // the back face's edges would be seen here
    }
  }
  CHECK(ink >= 4 * (box.width - 1));
  CHECK(inner == 0);
  CHECK(std::memcmp(plain.depth.row(32), wired.depth.row(32), sizeof(float) * 64) == 0);
  CHECK(std::memcmp(plain.triangle_id.row(32), wired.triangle_id.row(32), sizeof(float) * 64) == 0);
}

TEST_CASE("the edges of a triangle all show on it, however steep it is, and what is culled has none") {
  Random random{19};
  for (int i = 0; i < 200; ++i) {
    const auto corner = [&] {
      return glm::vec3(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-8.5, -2));
    };
    Mesh mesh;
    mesh.positions = {corner(), corner(), corner()};
    mesh.triangles = {glm::uvec3(0, 1, 2)};
    Mesh edges;
    edges.positions = mesh.positions;
    edges.segments = {glm::uvec2(0, 1), glm::uvec2(1, 2), glm::uvec2(0, 2)};
    Scene scene, outline;
    scene.add(mesh);
    outline.add(edges);
    RenderSettings settings = size(50, 50);
    const Picture lines = render(outline, eye(), settings);
    settings.wireframe = true;
    settings.shader = [](const SurfacePoint&) { return glm::vec4(1.0f); };
    const Picture wired = render(scene, eye(), settings);
    int missing = 0;
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 50; ++x) {
        const bool is_line = lines.triangle_id.at(x, y) != 0xFFFFFFFFu;
        missing += is_line != (wired.colour.at(x, y) == Rgba8{0, 0, 0, 255});
      }
    }
    CHECK(missing == 0);
    settings.cull = wired.counters.back_facing > 0 ? Cull::back : Cull::front;
    const Picture culled = render(scene, eye(), settings);
    CHECK(culled.colour.at(25, 25) == Rgba8{0, 0, 0, 0});
  }
}
