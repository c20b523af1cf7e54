// From the second frame on a Renderer asks for no memory. This program of its own counts every request of
// every thread: it stands in for malloc and its kin, which operator new calls.
#include <doctest/doctest.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <memory>
#include <velum/velum.hpp>

#include "small_scenes.hpp"

namespace {
std::atomic<std::uint64_t> requests{0};
}

// glibc's own, under the names it keeps for those who replace the usual ones.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++requests;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  ++requests;
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) noexcept {
  ++requests;
  return __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++requests;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  ++requests;
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? ENOMEM : 0;
}
}

using namespace velum;
using namespace velum::test;

namespace {

Texture stripes() {
  Image<Rgba8> image(16, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) image.at(x, y) = {static_cast<std::uint8_t>(16 * x), 90, 200, 255};
  }
  return Texture(image);
}

/// Solids, a texture, segments, points, triangles that reach behind the eye, and where wanted glass.
Scene scene_of(bool has_glass) {
  Scene scene = meeting_solids();
  Material textured;
  textured.texture = std::make_shared<const Texture>(stripes());
  Mesh quad;
  quad.positions = {glm::vec3(-3, -3, -1), glm::vec3(9, -3, -1), glm::vec3(3, 9, -1)};
  quad.texture_coordinates = {glm::vec2(0, 0), glm::vec2(4, 0), glm::vec2(4, 4)};
  quad.triangles = {glm::uvec3(0, 1, 2)};
  Mesh lines;
  lines.positions = {glm::vec3(-1, -1, 1), glm::vec3(1, 1, 1), glm::vec3(0, 1, 1)};
  lines.segments = {glm::uvec2(0, 1)};
  lines.points = {2u};
  scene.add(std::move(quad), glm::dmat4(1.0), scene.add_material(textured));
  scene.add(std::move(lines));
  if (!has_glass) return scene;
  Material glass;
  glass.alpha = 0.4f;
  scene.add(shapes::sphere(), moved({0.2, 0.5, 1.0}), scene.add_material(glass));
  return scene;
}

struct Outputs {
  Image<Rgba8> colour;
  Image<float> depth;
  Image<std::uint32_t> ids;

  explicit Outputs(const RenderSettings& settings)
      : colour(settings.width, settings.height),
        depth(settings.width, settings.height),
        ids(settings.width, settings.height) {}
  PictureTarget target() {
    PictureTarget result;
    result.colour = colour.view();
    result.depth = depth.view();
    result.triangle_id = ids.view();
    return result;
  }
};

/// How often memory was asked for in three frames after the first, with the camera going back and forth.
std::uint64_t requests_after_first_frame(const Scene& scene, const RenderSettings& settings,
                                         bool whole_picture) {
  const Camera here = camera_of(scene, "perspective", settings, glm::dvec3(0.4, 0.6, 3.0));
  const Camera there = camera_of(scene, "cabinet", settings);
  Renderer renderer;
  Outputs outputs(settings);
  const PictureTarget target = outputs.target();
  const auto draw = [&](const Camera& camera) {
    if (whole_picture) {
      renderer.render(scene, camera, settings);
    } else {
      renderer.render_into(scene, camera, settings, target);
    }
  };
  draw(here);
  draw(there);  // a first frame, too: it may have larger parts
  const std::uint64_t before = requests;
  draw(here);
  draw(there);
  draw(here);
  return requests - before;
}

void check_all(const Scene& scene, RenderSettings settings) {
  for (const bool whole_picture : {false, true}) {
    for (const ExecutorKind executor : {ExecutorKind::serial, ExecutorKind::std_thread}) {
      CAPTURE(whole_picture);
      CAPTURE(static_cast<int>(executor));
      settings.executor = executor;
      settings.threads = 3;
      CHECK(requests_after_first_frame(scene, settings, whole_picture) == 0);
    }
  }
}

RenderSettings settings_of(VisibilityMethod method = VisibilityMethod::zbuffer, Isa isa = Isa::best) {
  RenderSettings settings = size(160, 120);
  settings.visibility = method;
  settings.isa = isa;
  return settings;
}

}  // namespace

TEST_CASE("every way of asking for memory is counted") {
  std::uint64_t before = requests;
  const auto grows = [&before] {
    const std::uint64_t then = before;
    before = requests;
    return before > then;
  };
  std::unique_ptr<int> one = std::make_unique<int>(1);
  CHECK(grows());
  std::vector<double> many(1000);
  CHECK(grows());
  struct alignas(64) Line {
    char bytes[64] = {};
  };
  std::unique_ptr<Line> line = std::make_unique<Line>();
  CHECK(grows());
  void* block = std::malloc(100);
  CHECK(grows());
  block = std::realloc(block, 200);
  CHECK(grows());
  std::free(block);
  CHECK_FALSE(grows());
}

TEST_CASE("no memory is asked for after the first frame, whatever the method") {
  for (const bool has_glass : {false, true}) {
    CAPTURE(has_glass);
    const Scene scene = scene_of(has_glass);
    check_all(scene, settings_of(VisibilityMethod::zbuffer));
    check_all(scene, settings_of(VisibilityMethod::zbuffer, Isa::reference));
    check_all(scene, settings_of(VisibilityMethod::scanline));
  }
}

TEST_CASE("no memory is asked for after the first frame, whatever the shading") {
  const Scene scene = scene_of(true);
  for (const Shading shading : {Shading::flat, Shading::gouraud, Shading::normal, Shading::object_id}) {
    CAPTURE(static_cast<int>(shading));
    RenderSettings settings = settings_of();
    settings.shading = shading;
    check_all(scene, settings);
  }
}

TEST_CASE("no memory is asked for after the first frame with a wireframe, a crop or a custom shader") {
  const Scene scene = scene_of(true);
  RenderSettings settings = settings_of();
  settings.wireframe = true;
  check_all(scene, settings);
  settings.wireframe = false;
  settings.shader = [](const SurfacePoint&) { return glm::vec4(1.0f, 0.5f, 0.0f, 1.0f); };
  check_all(scene, settings);
}
