// Segments and points among triangles: one definition of what is seen, whatever the method.
#include <doctest/doctest.h>

#include <cstring>
#include <velum/velum.hpp>

#include "random.hpp"

using namespace velum;

namespace {

/// Triangles, segments and points over the same vertices, so many lie on each other and some reach behind the
/// viewer.
Scene tangle(std::uint64_t seed) {
  Random random{seed};
  Scene scene;
  for (int instance = 0; instance < 2; ++instance) {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    std::vector<glm::uvec2> segments;
    std::vector<std::uint32_t> points;
    for (std::uint32_t i = 0; i < 24; ++i) {
      positions.emplace_back(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-9, 1));
      points.push_back(i);
      if (i < 2) continue;
      segments.emplace_back(i - 1, i);
      segments.emplace_back(i, i - 1);  // twice: the depths tie
      if (i % 4 == 0) triangles.emplace_back(i - 2, i - 1, i);
    }
    Mesh mesh;
    mesh.positions = positions;
    mesh.triangles = triangles;
    mesh.segments = segments;
    mesh.points = points;
    scene.add(mesh);
  }
  return scene;
}

RenderSettings settings_for(std::uint64_t seed) {
  RenderSettings settings;
  settings.width = 48;
  settings.height = 40;
  settings.line_width = 1.0f + 0.375f * static_cast<float>(seed % 7);
  settings.point_size = 1.0f + 0.75f * static_cast<float>(seed % 5);
  return settings;
}

Camera camera_for(std::uint64_t seed) {
  if (seed % 2 == 0) return Camera::perspective({}, {}, 1.0, 9.0);
  ParallelWindow window;
  window.height = 7.0;
  return Camera::parallel({}, window, 1.0, 9.0);
}

template <typename T>
bool same_bytes(const Image<T>& a, const Image<T>& b) {
  for (int y = 0; y < a.height(); ++y) {
    const std::size_t bytes = sizeof(T) * static_cast<std::size_t>(a.width());
    if (std::memcmp(a.row(y), b.row(y), bytes) != 0) return false;
  }
  return true;
}

/// Pixels whose id is not that of the first fragment of the definition.
int disagreements(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                  const Picture& picture, int* lines) {
  int wrong = 0;
  for (int y = 0; y < settings.height; ++y) {
    for (int x = 0; x < settings.width; ++x) {
      const PixelExplanation pixel = explain_pixel(scene, camera, settings, x, y);
      const std::uint32_t seen = pixel.fragments.empty() ? no_primitive : pixel.fragments[0].primitive;
      wrong += picture.triangle_id.at(x, y) != seen;
      *lines += seen != no_primitive && scene.place(seen).kind != PrimitiveKind::triangle;
    }
  }
  return wrong;
}

}  // namespace

TEST_CASE("scanline and z-buffer show the same segments and points, to the bit") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const Scene scene = tangle(seed);
    RenderSettings settings = settings_for(seed);
    const Picture zbuffer = render(scene, camera_for(seed), settings);
    settings.visibility = VisibilityMethod::scanline;
    const Picture scanline = render(scene, camera_for(seed), settings);
    CHECK(zbuffer.coverage() > 0.1);
    CHECK(same_bytes(zbuffer.triangle_id, scanline.triangle_id));
    CHECK(same_bytes(zbuffer.depth, scanline.depth));
    CHECK(same_bytes(zbuffer.metric_depth, scanline.metric_depth));
    CHECK(same_bytes(zbuffer.colour, scanline.colour));
    settings.visibility = VisibilityMethod::zbuffer;
    settings.isa = Isa::reference;
    CHECK(render(scene, camera_for(seed), settings).counters.fragments == scanline.counters.fragments);
  }
}

TEST_CASE("of segments, points and triangles the smallest (depth, primitive id) is seen") {
  int lines = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    CAPTURE(seed);
    const Scene scene = tangle(seed);
    const RenderSettings settings = settings_for(seed);
    const Camera camera = camera_for(seed);
    CHECK(disagreements(scene, camera, settings, render(scene, camera, settings), &lines) == 0);
  }
  CHECK(lines > 1000);
}
