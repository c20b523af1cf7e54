// The same bytes with any executor, number of threads, instruction set and set of outputs.
#include <doctest/doctest.h>

#include <cstring>
#include <thread>
#include <velum/pipeline/tile_stage.hpp>
#include <velum/velum.hpp>

#include "small_scenes.hpp"

using namespace velum;
using velum::test::meeting_solids;
using velum::test::moved;

namespace {

Camera camera_of(const Scene& scene) {
  FrameOptions options;
  options.aspect = 160.0 / 120.0;
  return frame(scene.bounds(), projection::perspective(), options);
}

RenderSettings settings_of(int threads = 1, ExecutorKind executor = ExecutorKind::tbb) {
  RenderSettings settings;
  settings.width = 160;
  settings.height = 120;
  settings.threads = threads;
  settings.executor = executor;
  return settings;
}

template <typename T>
bool same_rows(const Image<T>& a, const Image<T>& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y) {
    if (std::memcmp(a.row(y), b.row(y), sizeof(T) * static_cast<std::size_t>(a.width())) != 0) return false;
  }
  return true;
}

bool same_picture(const Picture& a, const Picture& b) {
  return same_rows(a.colour, b.colour) && same_rows(a.depth, b.depth) &&
         same_rows(a.metric_depth, b.metric_depth) && same_rows(a.normal, b.normal) &&
         same_rows(a.object_id, b.object_id) && same_rows(a.triangle_id, b.triangle_id) &&
         std::memcmp(&a.counters, &b.counters, sizeof(Counters)) == 0;
}

/// With something translucent, too.
Scene glassy_solids() {
  Scene scene = meeting_solids();
  Material glass;
  glass.alpha = 0.4f;
  scene.add(shapes::sphere(), moved({0.2, 0.5, 1.0}), scene.add_material(glass));
  return scene;
}

}  // namespace

TEST_CASE("any executor and number of threads gives the same picture and counters") {
  const Scene scene = glassy_solids();
  const Camera camera = camera_of(scene);
  const Picture expected = render(scene, camera, settings_of());
  CHECK(expected.counters.layers > 1);
  for (const ExecutorKind kind : {ExecutorKind::tbb, ExecutorKind::std_thread, ExecutorKind::serial}) {
    for (const int threads : {0, 1, 2, 7, 16}) {
      CAPTURE(threads);
      CHECK(same_picture(render(scene, camera, settings_of(threads, kind)), expected));
    }
  }
}

TEST_CASE("two Renderers draw one const Scene in two threads at once") {
  const Scene scene = glassy_solids();
  const Camera camera = camera_of(scene);
  const Picture expected = render(scene, camera, settings_of());
  bool is_same[2] = {};
  const auto draw = [&](bool& same) {
    Renderer renderer;
    same = true;
    for (int i = 0; i < 5; ++i) {
      same = same &&
             same_picture(renderer.render(scene, camera, settings_of(2, ExecutorKind::std_thread)), expected);
    }
  };
  std::thread other(draw, std::ref(is_same[0]));
  draw(is_same[1]);
  other.join();
  CHECK(is_same[0]);
  CHECK(is_same[1]);
}

TEST_CASE("a Renderer goes from one number of threads, size and instruction set to the next") {
  const Scene scene = meeting_solids();
  const Camera camera = camera_of(scene);
  Renderer renderer;
  for (const int threads : {2, 1, 5, 5}) {
    for (const Isa isa : available_isas()) {
      RenderSettings settings = settings_of(threads, ExecutorKind::std_thread);
      settings.isa = isa;
      settings.width = 40 * threads;
      settings.height = 30 * threads;
      RenderSettings plain = settings;
      plain.isa = Isa::reference;
      plain.threads = 1;
      const Picture expected = render(scene, camera, plain);
      const Picture& actual = renderer.render(scene, camera, settings);
      CHECK(same_rows(actual.colour, expected.colour));
      CHECK(same_rows(actual.triangle_id, expected.triangle_id));
      CHECK(same_rows(actual.depth, expected.depth));
    }
  }
}

TEST_CASE("outputs wanted one by one equal those of the whole picture") {
  const Scene scene = meeting_solids();
  const Camera camera = camera_of(scene);
  const Picture whole = render(scene, camera, settings_of());
  Picture one = whole;
  one.colour.fill({});
  one.depth.fill(-1.0f);
  one.metric_depth.fill(-1.0f);
  one.normal.fill({});
  one.object_id.fill(77);
  one.triangle_id.fill(77);
  Renderer renderer;
  const auto draw = [&](const PictureTarget& target) {
    renderer.render_into(scene, camera, settings_of(), target);
  };
  draw({.colour = one.colour.view()});
  draw({.depth = one.depth.view()});
  draw({.metric_depth = one.metric_depth.view()});
  draw({.normal = one.normal.view()});
  draw({.object_id = one.object_id.view()});
  draw({.triangle_id = one.triangle_id.view()});
  CHECK(same_picture(one, whole));
}

TEST_CASE("colours and object ids alone equal those of the whole picture, in every shading") {
  const Scene scene = glassy_solids();
  const Camera camera = camera_of(scene);
  for (const Shading shading :
       {Shading::flat, Shading::gouraud, Shading::phong, Shading::normal, Shading::depth, Shading::object_id,
        Shading::triangle_id, Shading::barycentric}) {
    CAPTURE(static_cast<int>(shading));
    RenderSettings settings = settings_of();
    settings.shading = shading;
    const Picture whole = render(scene, camera, settings);
    Image<Rgba8> colour(160, 120);
    Image<std::uint32_t> object_id(160, 120);
    Renderer().render_into(scene, camera, settings, {.colour = colour.view(), .object_id = object_id.view()});
    CHECK(same_rows(colour, whole.colour));
    CHECK(same_rows(object_id, whole.object_id));
  }
}

TEST_CASE("more primitives than one wave holds, in one mesh and in many instances") {
  Scene scene;
  scene.add(shapes::grid(2.0f, 600));  // 720,000 triangles: waves of 2¹⁸
  const std::uint32_t ball = scene.add_mesh(shapes::sphere());
  for (int i = 0; i < 40; ++i) {
    Instance instance;
    instance.mesh = ball;
    instance.world_from_object = moved({0.1 * (i % 7) - 0.3, 0.1 * (i % 5), 0.1 * (i % 6) - 0.3});
    scene.add_instance(instance);
  }
  const Camera camera = camera_of(scene);
  RenderSettings plain = settings_of();
  plain.isa = Isa::reference;
  const Picture expected = render(scene, camera, plain);
  const Picture actual = render(scene, camera, settings_of(3));
  CHECK(same_rows(actual.triangle_id, expected.triangle_id));
  CHECK(same_rows(actual.depth, expected.depth));
  CHECK(actual.counters.triangles == expected.counters.triangles);
  CHECK(actual.counters.back_facing == expected.counters.back_facing);
  CHECK(actual.counters.reversed == expected.counters.reversed);
}

TEST_CASE(
    "waves that end with an instance, batches of many instances, and more vertices than a round holds") {
  Mesh quad;
  quad.positions = {glm::vec3(-1, -1, 0), glm::vec3(1, -1, 0), glm::vec3(1, 1, 0), glm::vec3(-1, 1, 0)};
  quad.triangles = {glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 3)};
  Scene exact;  // 2¹⁹ triangles: two waves to the last one
  exact.add(shapes::grid(2.0f, 512));
  exact.add(quad);
  Scene many;  // 2.5 million vertices, as they are counted: a round and a bit
  const std::uint32_t mesh = many.add_mesh(quad);
  for (int i = 0; i < 70000; ++i) {
    Instance instance;
    instance.mesh = mesh;
    instance.world_from_object = moved({0.01 * (i % 97), 0.01 * (i % 89), 0.001 * (i % 101)});
    many.add_instance(instance);
  }
  for (const Scene* scene : {&exact, &many}) {
    RenderSettings plain = settings_of();
    plain.isa = Isa::reference;
    const Camera camera = camera_of(*scene);
    const Picture expected = render(*scene, camera, plain);
    const Picture actual = render(*scene, camera, settings_of(3));
    CHECK(same_rows(actual.triangle_id, expected.triangle_id));
    CHECK(same_rows(actual.depth, expected.depth));
  }
}

TEST_CASE("vertices that wait take no more memory than the ceiling counts") {
  // Large meshes among small ones: 4.8 million vertices.
  Scene scene;
  const std::uint32_t large = scene.add_mesh(shapes::grid(2.0f, 400));
  const std::uint32_t small = scene.add_mesh(shapes::grid(2.0f, 10));
  for (int i = 0; i < 300; ++i) {
    Instance instance;
    instance.mesh = i % 10 == i / 30 ? large : small;
    instance.world_from_object = moved({0.01 * i, 0.0, 0.0});
    scene.add_instance(instance);
  }
  const Camera camera = camera_of(scene);
  const RenderSettings settings = settings_of();
  const ViewingTransform viewing = camera.viewing_transform(160.0 / 120.0);
  Executor executor(1, ExecutorKind::serial);
  const std::function<void(double)> progress = [](double) {};
  TileStageBuffers buffers;
  VisibilityBuffer visibility(160, 120);
  Counters counters;
  draw_in_tiles({scene, viewing, settings, {0, 0, 160, 120}, executor, progress}, buffers, visibility,
                counters);
  CHECK(counters.instances == 300);
  CHECK(buffers.placed.room() == std::size_t{1} << 21);
  const std::uint64_t bytes = buffers.placed.room() * sizeof(PlacedVertex) +
                              buffers.nearness.room() * sizeof(float) +
                              buffers.vertices.size() * sizeof(PlacedVertices);
  CHECK(bytes < tile_stage_bytes(scene));
}

TEST_CASE("a wireframe is the same on any number of threads, over several runs of triangles and bands") {
  Scene scene = meeting_solids();
  scene.add(shapes::grid(2.0f, 70), moved({0.0, -0.4, 0.3}));
  const Camera camera = camera_of(scene);
  RenderSettings settings = settings_of();
  settings.wireframe = true;
  const Picture expected = render(scene, camera, settings);
  settings.wireframe = false;
  CHECK_FALSE(same_rows(render(scene, camera, settings).colour, expected.colour));
  for (const int threads : {2, 7}) {
    RenderSettings parallel = settings_of(threads, ExecutorKind::std_thread);
    parallel.wireframe = true;
    CHECK(same_picture(render(scene, camera, parallel), expected));
  }
}

TEST_CASE("threads and instruction sets that cannot be had are errors that say so") {
  const Scene scene = meeting_solids();
  const Camera camera = camera_of(scene);
  CHECK_THROWS_WITH_AS(render(scene, camera, settings_of(-1)), doctest::Contains("-1 threads"), Error);
  CHECK_THROWS_AS(render(scene, camera, settings_of(most_threads + 1)), Error);
  for (const Isa isa : {Isa::sse4, Isa::avx2, Isa::avx512, Isa::neon}) {
    if (is_available(isa)) continue;
    RenderSettings settings = settings_of();
    settings.isa = isa;
    CHECK_THROWS_WITH_AS(render(scene, camera, settings), doctest::Contains(name_of(isa)), Error);
  }
}

TEST_CASE("a custom shader is called on the calling thread") {
  const Scene scene = meeting_solids();
  const std::thread::id here = std::this_thread::get_id();
  int elsewhere = 0;
  RenderSettings settings = settings_of(4, ExecutorKind::std_thread);
  settings.shader = [&](const SurfacePoint&) {
    elsewhere += std::this_thread::get_id() != here;
    return glm::vec4(1.0f);
  };
  CHECK(render(scene, camera_of(scene), settings).coverage() > 0.1);
  CHECK(elsewhere == 0);
}
