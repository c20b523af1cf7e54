// Shading by vectors: the plain loops' bytes, whatever is wanted of a picture.
#include <doctest/doctest.h>

#include <cstring>
#include <velum/velum.hpp>

#include "shading/shading_names.hpp"
#include "small_scenes.hpp"

using namespace velum;
using velum::test::meeting_solids;
using velum::test::moved;

namespace {

constexpr int width = 75, height = 67;

/// Opaque and translucent solids, some smooth, among lines.
Scene solids_and_glass() {
  Scene scene = meeting_solids();
  Material glass;
  glass.alpha = 0.4f;
  glass.base_colour = {0.2f, 0.5f, 0.9f};
  glass.shininess = 90.0f;
  const std::uint32_t material = scene.add_material(glass);
  scene.add(shapes::torus(), moved({0.3, 0.2, 0.9}), material);
  scene.add(shapes::torus(), moved({-0.4, 0.1, -0.2}));
  Mesh lines;
  lines.positions = {{-2, -1, 0}, {2, 1, 1}, {0, 1, 2}};
  lines.segments = {{0, 1}, {1, 2}};
  lines.points = {0, 2};
  scene.add(lines);
  scene.point_lights = {{{3, 4, 5}, glm::vec3(0.6f)}, {{-3, 0, 2}, glm::vec3(0.1f, 0.3f, 0.2f)}};
  scene.directional_lights = {{{-1, -2, -1}, glm::vec3(0.4f)}};
  return scene;
}

struct Outputs {
  bool colour, metric_depth, normal, object_id;
};

/// What was asked for; the rest stays as it was made.
Picture rendered(const Scene& scene, const RenderSettings& settings, const Outputs& wanted) {
  const double aspect = static_cast<double>(width) / height;
  const Camera camera = frame(scene.bounds(), projection::perspective(), {.aspect = aspect});
  Picture picture;
  picture.colour.resize(width, height, {1, 2, 3, 4});
  picture.depth.resize(width, height, -1.0f);
  picture.metric_depth.resize(width, height, -1.0f);
  picture.normal.resize(width, height, glm::vec3(7.0f));
  picture.object_id.resize(width, height, 99);
  picture.triangle_id.resize(width, height, 99);
  PictureTarget target{.depth = picture.depth.view(), .triangle_id = picture.triangle_id.view()};
  if (wanted.colour) target.colour = picture.colour.view();
  if (wanted.metric_depth) target.metric_depth = picture.metric_depth.view();
  if (wanted.normal) target.normal = picture.normal.view();
  if (wanted.object_id) target.object_id = picture.object_id.view();
  picture.counters = Renderer().render_into(scene, camera, settings, target);
  return picture;
}

template <typename T>
bool same(const Image<T>& a, const Image<T>& b) {
  for (int y = 0; y < height; ++y) {
    if (std::memcmp(a.row(y), b.row(y), width * sizeof(T)) != 0) return false;
  }
  return true;
}

void check_same(const Picture& actual, const Picture& expected) {
  CHECK(same(actual.colour, expected.colour));
  CHECK(same(actual.depth, expected.depth));
  CHECK(same(actual.metric_depth, expected.metric_depth));
  CHECK(same(actual.normal, expected.normal));
  CHECK(same(actual.object_id, expected.object_id));
  CHECK(same(actual.triangle_id, expected.triangle_id));
  CHECK(actual.counters.pixels_shaded == expected.counters.pixels_shaded);
  CHECK(actual.counters.layers == expected.counters.layers);
}

void check_every_isa(const Scene& scene, RenderSettings settings, const Outputs& wanted) {
  settings.isa = Isa::reference;
  settings.threads = 1;
  const Picture expected = rendered(scene, settings, wanted);
  for (const Isa isa : available_isas()) {
    CAPTURE(name_of(isa));
    settings.isa = isa;
    settings.threads = 3;
    check_same(rendered(scene, settings, wanted), expected);
  }
}

}  // namespace

TEST_CASE("every shading, with every instruction set, for every set of outputs") {
  const Scene opaque = meeting_solids();
  const Scene scene = solids_and_glass();
  for (const NamedShading& named : shading_names) {
    CAPTURE(named.name);
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.shading = named.shading;
    settings.background = {40, 50, 60, 128};
    for (const Outputs& wanted : {Outputs{true, true, true, true}, Outputs{true, false, false, false},
                                  Outputs{false, true, false, false}, Outputs{true, false, true, false},
                                  Outputs{false, false, false, true}, Outputs{}}) {
      check_every_isa(scene, settings, wanted);
      check_every_isa(opaque, settings, wanted);
    }
    settings.wireframe = true;
    check_every_isa(scene, settings, {true, true, true, true});
  }
}

TEST_CASE(
    "a shader that is compiled in gives the bytes of the same one as a function, on any number of threads") {
  const Scene scene = solids_and_glass();
  const auto shader = [](const SurfacePoint& point) {
    const float share = point.x % 3 == 0 ? 0.5f : 1.0f;
    return glm::vec4(point.barycentric * 0.5f + point.shading_normal * 0.25f + 0.25f, share);
  };
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  for (const bool wireframe : {false, true}) {
    settings.wireframe = wireframe;
    settings.inlined_shader = {};
    settings.shader = shader;
    const Picture expected = rendered(scene, settings, {true, true, true, true});
    settings.shader = [](const SurfacePoint&) { return glm::vec4(0.0f); };  // replaced
    settings.inlined_shader = ShaderRef(shader);
    for (const int threads : {1, 2, 7}) {
      settings.threads = threads;
      check_same(rendered(scene, settings, {true, true, true, true}), expected);
    }
  }
}

TEST_CASE("what a compiled-in shader throws ends the render") {
  const Scene scene = meeting_solids();
  const Camera camera = frame(scene.bounds(), projection::perspective());
  const auto shader = [](const SurfacePoint& point) -> glm::vec4 {
    if (point.object == 1) throw 5;
    return glm::vec4(1.0f);
  };
  CHECK_THROWS_AS(render_with(scene, camera, {.width = 100, .height = 100}, shader), int);
}

TEST_CASE("further layers on any number of threads") {
  const Scene scene = solids_and_glass();
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  for (const std::uint64_t layers : {0, 1, 2, 3}) {
    settings.layers = layers;
    settings.threads = 1;
    const Picture expected = rendered(scene, settings, {true, true, true, true});
    CHECK(expected.counters.layers == (layers == 0 ? 3 : layers));
    for (const int threads : {2, 7}) {
      settings.threads = threads;
      settings.executor = ExecutorKind::std_thread;
      check_same(rendered(scene, settings, {true, true, true, true}), expected);
    }
  }
}
