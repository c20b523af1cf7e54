// The hierarchical method gives the scanline's bytes, whatever it leaves out.
#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <velum/velum.hpp>

#include "small_scenes.hpp"

using namespace velum;
using velum::test::moved;

namespace {

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
         same_rows(a.triangle_id, b.triangle_id) && same_rows(a.object_id, b.object_id);
}

bool same_counters(const Counters& a, const Counters& b) {
  return std::memcmp(&a, &b, sizeof(Counters)) == 0;
}

/// Many solids in a small space, some mirrored, some exactly where another is (ties at every pixel), some
/// coplanar with another's faces.
Scene crowded_scene(Random& random) {
  Scene scene;
  const std::uint32_t meshes[] = {scene.add_mesh(shapes::cube()),
                                  scene.add_mesh(shapes::torus(0.5f, 0.2f, 14, 9)),
                                  scene.add_mesh(shapes::sphere()), scene.add_mesh(shapes::letter_f())};
  glm::dmat4 last(1.0);
  const int count = 10 + random.below(50);
  for (int i = 0; i < count; ++i) {
    Instance instance;
    instance.mesh = meshes[random.below(4)];
    if (random.below(4) != 0) {
      const double size = random.uniform(0.05, 0.5) * (random.below(3) == 0 ? -1.0 : 1.0);
      last = moved({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
      last[0].x = size;
      last[1].y = random.uniform(0.1, 0.5);
      last[2].z = random.uniform(0.1, 0.5);
      last[0].y = random.uniform(-0.2, 0.2);
    }
    instance.world_from_object = last;
    scene.add_instance(instance);
  }
  return scene;
}

Camera random_camera(Random& random, const Scene& scene, const RenderSettings& settings) {
  const char* projections[] = {"perspective", "cabinet", "isometric", "two-point"};
  if (random.below(3) != 0) return test::camera_of(scene, projections[random.below(4)], settings);
  const auto coordinate = [&] { return random.uniform(-0.8, 0.8); };
  const Pose pose = Pose::towards({coordinate(), coordinate(), coordinate()},
                                  {coordinate() + 3.0, coordinate(), coordinate()});
  return Camera::perspective(pose, {VerticalAngle{1.2}}, 0.05, 4.0);
}

/// So few triangles in a node and in a batch that there is much to decide in a small scene.
RenderSettings settings_of(VisibilityMethod method) {
  RenderSettings settings = test::size(120, 90);
  settings.visibility = method;
  settings.shading = Shading::triangle_id;
  settings.hierarchy.leaf_size = 12;
  settings.hierarchy.batch_size = 300;
  return settings;
}

Picture hierarchical(const Scene& scene, const Camera& camera, const HierarchySettings& hierarchy,
                     Isa isa = Isa::best, int threads = 1, Cull cull = Cull::none) {
  RenderSettings settings = settings_of(VisibilityMethod::hierarchical);
  settings.hierarchy = hierarchy;
  settings.isa = isa;
  settings.threads = threads;
  settings.cull = cull;
  return render(scene, camera, settings);
}

void check_seeds(std::uint64_t first, std::uint64_t last) {
  std::uint64_t hidden = 0, outside = 0, polygons = 0, left_out = 0, all = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    Random random{seed * 1000 + 7};
    const Scene scene = crowded_scene(random);
    RenderSettings settings = settings_of(VisibilityMethod::scanline);
    settings.cull = static_cast<Cull>(random.below(3));
    const Camera camera = random_camera(random, scene, settings);
    const Picture expected = render(scene, camera, settings);
    settings.visibility = VisibilityMethod::hierarchical;
    settings.hierarchy.use = static_cast<HierarchyUse>(random.below(3));
    settings.hierarchy.placement = static_cast<OctreePlacement>(random.below(2));
    for (const Isa isa : {Isa::reference, Isa::best}) {
      settings.isa = isa;
      Renderer renderer;
      for (int frame = 0; frame < 2; ++frame) {  // the second remembers what was seen
        const Picture& actual = renderer.render(scene, camera, settings);
        CHECK(same_picture(actual, expected));
        const HierarchyCounters& counters = actual.counters.hierarchy;
        hidden += counters.nodes_hidden;
        outside += counters.nodes_outside;
        polygons += counters.polygons_hidden;
        left_out += counters.triangles_left_out;
        all += scene.primitive_count();
        CHECK(actual.counters.triangles + counters.triangles_left_out == scene.primitive_count());
      }
    }
  }
  CHECK((hidden > 0 && outside > 0 && polygons > 0));
  CHECK(left_out > all / 8);
}

/// A scene with something to leave out for every reason.
struct Crowd {
  Random random{99};
  Scene scene = crowded_scene(random);
  Camera camera =
      Camera::perspective(Pose::towards({0.1, 0.2, 1.6}, {0.2, 0.0, 0.0}), {VerticalAngle{0.8}}, 0.05, 10.0);
  Picture expected(Cull cull) const {
    RenderSettings settings = settings_of(VisibilityMethod::scanline);
    settings.cull = cull;
    return render(scene, camera, settings);
  }
};

HierarchySettings small_nodes() {
  return settings_of(VisibilityMethod::hierarchical).hierarchy;
}

}  // namespace

TEST_CASE("hierarchical equals scanline on 200 crowded scenes with exact ties") {
  check_seeds(0, 200);
}

TEST_CASE("each kind of culling left out changes the counters, not the picture") {
  const Crowd crowd;
  const Picture expected = crowd.expected(Cull::back);
  const auto draw = [&](const HierarchySettings& hierarchy) {
    const Picture picture = hierarchical(crowd.scene, crowd.camera, hierarchy, Isa::best, 1, Cull::back);
    CHECK(same_picture(picture, expected));
    return picture.counters.hierarchy;
  };
  const HierarchyCounters all = draw(small_nodes());
  CHECK((all.nodes_outside > 0 && all.nodes_hidden > 0 && all.clusters_away > 0));
  CHECK((all.polygons_hidden > 0 && all.triangles_left_out > 0));

  HierarchySettings no_frustum = small_nodes();
  no_frustum.culls_frustum = false;
  CHECK(draw(no_frustum).nodes_outside == 0);
  HierarchySettings no_pyramid = small_nodes();
  no_pyramid.culls_pyramid = false;
  const HierarchyCounters without_pyramid = draw(no_pyramid);
  CHECK(without_pyramid.nodes_hidden == 0);
  CHECK(without_pyramid.triangles_left_out < all.triangles_left_out);
  HierarchySettings no_cones = small_nodes();
  no_cones.culls_cones = false;
  CHECK(draw(no_cones).clusters_away == 0);
  HierarchySettings only_octree = small_nodes();
  only_octree.use = HierarchyUse::octree;
  CHECK(draw(only_octree).polygons_tested == 0);
  HierarchySettings only_polygons = small_nodes();
  only_polygons.use = HierarchyUse::polygons;
  const HierarchyCounters polygons = draw(only_polygons);
  CHECK((polygons.nodes_visited == 0 && polygons.triangles_left_out == 0 && polygons.polygons_hidden > 0));
}

TEST_CASE("normal cones leave out what is culled, of mirrored instances too") {
  const Crowd crowd;
  for (const Cull cull : {Cull::back, Cull::front}) {
    HierarchySettings only_cones = small_nodes();
    only_cones.culls_pyramid = only_cones.culls_frustum = false;
    const Picture picture = hierarchical(crowd.scene, crowd.camera, only_cones, Isa::best, 1, cull);
    CHECK(same_picture(picture, crowd.expected(cull)));
    CHECK(picture.counters.hierarchy.clusters_away > 20);
  }
}

TEST_CASE("the counters do not depend on threads, nor the plain stages' decisions on the kernels") {
  const Crowd crowd;
  const Picture one = hierarchical(crowd.scene, crowd.camera, small_nodes());
  const Picture expected = crowd.expected(Cull::none);
  CHECK(same_picture(one, expected));
  for (const int threads : {2, 7}) {
    for (const Isa isa : available_isas()) {
      const Picture other = hierarchical(crowd.scene, crowd.camera, small_nodes(), isa, threads);
      CHECK(same_picture(other, expected));
      CHECK(other.counters.triangles == one.counters.triangles);
      CHECK(other.counters.hierarchy.nodes_visited == one.counters.hierarchy.nodes_visited);
      CHECK(other.counters.hierarchy.nodes_hidden == one.counters.hierarchy.nodes_hidden);
      if (isa != Isa::reference) CHECK(same_counters(other.counters, one.counters));
    }
  }
}

TEST_CASE("a Renderer draws what it remembers first, and goes on after the scene changes") {
  Crowd crowd;
  RenderSettings settings = settings_of(VisibilityMethod::hierarchical);
  Renderer renderer;
  const Counters first = renderer.render(crowd.scene, crowd.camera, settings).counters;
  CHECK(first.hierarchy.clusters_remembered == 0);
  const Picture expected = crowd.expected(Cull::none);
  const Picture& second = renderer.render(crowd.scene, crowd.camera, settings);
  CHECK(second.counters.hierarchy.clusters_remembered > 0);
  CHECK(second.counters.triangles <= first.triangles);
  CHECK(same_picture(second, expected));

  // From elsewhere, in another size, and in part.
  const Camera other =
      Camera::perspective(Pose::towards({1.5, 0.2, -0.9}, {0.2, 0.0, 0.0}), {VerticalAngle{0.8}}, 0.05, 10.0);
  settings.crop = Rect{30, 20, 70, 65};
  RenderSettings plain = settings;
  plain.visibility = VisibilityMethod::scanline;
  CHECK(same_picture(renderer.render(crowd.scene, other, settings), render(crowd.scene, other, plain)));

  crowd.scene.set_world_from_object(0, moved({0.2, 0.0, 0.9}));
  const Picture& changed = renderer.render(crowd.scene, crowd.camera, settings);
  CHECK(changed.counters.hierarchy.clusters_remembered == 0);
  CHECK(same_picture(changed, render(crowd.scene, crowd.camera, plain)));
}

TEST_CASE("hierarchical keeps the bytes with glass, lines, other depth formats and odd numbers") {
  Scene scene = test::meeting_solids();
  Material glass;
  glass.alpha = 0.4f;
  scene.add(shapes::sphere(), moved({0.2, 0.5, 1.0}), scene.add_material(glass));
  Mesh lines;
  lines.positions = {glm::vec3(-1, -1, 1), glm::vec3(1, 1, 1), glm::vec3(0.5f, -0.5f, 1.2f)};
  lines.segments = {glm::uvec2(0, 1), glm::uvec2(1, 2)};
  lines.points = {2};
  scene.add(lines);
  Mesh odd;
  odd.positions = {glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0),
                   glm::vec3(std::numeric_limits<float>::quiet_NaN(), 0, 0)};
  odd.triangles = {glm::uvec3(0, 1, 2), glm::uvec3(0, 1, 3), glm::uvec3(0, 1, 1)};
  scene.add(odd);
  glm::dmat4 huge(1e300);
  huge[3].w = 1.0;
  huge[0].w = huge[1].w = huge[2].w = 0.0;
  Mesh far_away = shapes::cube();
  scene.add(far_away, huge);
  for (const DepthFormat format : {DepthFormat::reversed, DepthFormat::z8}) {
    for (const Isa isa : {Isa::reference, Isa::best}) {
      RenderSettings settings = settings_of(VisibilityMethod::scanline);
      settings.depth_format = format;
      settings.shading = Shading::phong;
      settings.isa = isa;
      const Camera camera = Camera::perspective(Pose::towards({0.5, 0.8, 4.0}, {0.0, 0.0, 0.0}),
                                                {VerticalAngle{0.8}}, 0.5, 20.0);
      const Picture expected = render(scene, camera, settings);
      settings.visibility = VisibilityMethod::hierarchical;
      const Picture actual = render(scene, camera, settings);
      CHECK(same_picture(actual, expected));
      CHECK(actual.counters.not_finite == expected.counters.not_finite);
      CHECK(actual.counters.segments == expected.counters.segments);
    }
  }
}

TEST_CASE("an empty scene, and one of lines alone, have nothing to leave out") {
  RenderSettings settings = settings_of(VisibilityMethod::hierarchical);
  const Camera camera = Camera::perspective({}, {VerticalAngle{0.8}}, 0.5, 20.0);
  CHECK(render(Scene(), camera, settings).coverage() == 0.0);
  Scene scene;
  Mesh lines;
  lines.positions = {glm::vec3(-1, -1, -3), glm::vec3(1, 1, -3)};
  lines.segments = {glm::uvec2(0, 1)};
  scene.add(lines);
  CHECK(render(scene, camera, settings).coverage() > 0.0);
}
