// The two clip policies: other cuts, the same picture but for centres within √2/512 pixel of an edge.
#include <doctest/doctest.h>

#include <cstring>
#include <velum/velum.hpp>

#include "small_scenes.hpp"
#include "visibility/classify.hpp"

using namespace velum;
using namespace velum::test;

namespace {

RenderSettings settings_of(ClipPolicy policy, int width = 96, int height = 72) {
  RenderSettings settings = size(width, height);
  settings.clip = policy;
  return settings;
}

struct PolicyDifference {
  int unexplained = 0;
  int other_depths = 0;  ///< the same triangle with other bits
  int at_edges = 0;
};

void compare_policies(const Scene& scene, const Camera& camera, PolicyDifference& difference) {
  const Picture exact = render(scene, camera, settings_of(ClipPolicy::exact));
  const Picture guard = render(scene, camera, settings_of(ClipPolicy::guard));
  const oracle::Eye eye(camera, 96, 72);
  const std::vector<oracle::WorldTriangle> triangles = oracle::world_triangles(scene);
  const oracle::Classifier classifier(eye, triangles);
  for (int y = 0; y < 72; ++y) {
    for (int x = 0; x < 96; ++x) {
      const std::uint32_t a = exact.triangle_id.at(x, y), b = guard.triangle_id.at(x, y);
      if (a == b) {
        difference.other_depths +=
            std::memcmp(&exact.depth.at(x, y), &guard.depth.at(x, y), sizeof(float)) != 0;
        continue;
      }
      // The raster's own tie rule is the same for both: only coverage may be the reason.
      const oracle::Reason reason = classifier.reason(x, y, a, {b, 0.0, -1.0});
      const bool is_at_edge = reason == oracle::Reason::edge || reason == oracle::Reason::cut;
      ++(is_at_edge ? difference.at_edges : difference.unexplained);
    }
  }
}

/// A viewer among triangles that reach far beyond the picture on all sides and behind the eye.
Camera inside(std::uint64_t seed) {
  Random random{seed};
  const glm::dvec3 eye(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
  const Pose pose = Pose::towards(eye, {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
  return Camera::perspective(pose, {VerticalAngle{1.4}}, 0.05, 6.0);
}

Scene room() {
  Scene scene;
  scene.add(shapes::cube(3.0f));
  scene.add(shapes::grid(4.0f, 3), moved({0.0, -0.8, 0.0}));
  scene.add(shapes::torus(1.2f, 0.4f, 24, 12));
  return scene;
}

bool same_answer(const Picture& a, const Picture& b) {
  for (int y = 0; y < a.depth.height(); ++y) {
    const auto width = static_cast<std::size_t>(a.depth.width());
    if (std::memcmp(a.depth.row(y), b.depth.row(y), width * sizeof(float)) != 0 ||
        std::memcmp(a.triangle_id.row(y), b.triangle_id.row(y), width * sizeof(std::uint32_t)) != 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("policies differ only at centres within √2/512 pixel of a true edge, and depth not at all") {
  PolicyDifference difference;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    compare_policies(random_triangles(seed, 60), inside(seed), difference);
    compare_policies(room(), inside(seed + 1000), difference);
  }
  CHECK(difference.unexplained == 0);
  CHECK(difference.other_depths == 0);
  CHECK(difference.at_edges > 0);  // otherwise nothing was tried
}

TEST_CASE("a guard band cuts less, and the counters add up under either policy") {
  const Scene scene = random_triangles(3, 400);
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Counters exact = render(scene, inside(seed), settings_of(ClipPolicy::exact)).counters;
    const Counters guard = render(scene, inside(seed), settings_of(ClipPolicy::guard)).counters;
    CHECK(guard.clipped < exact.clipped);
    CHECK(guard.clipped > 0);
    CHECK(guard.trivially_accepted > exact.trivially_accepted);
    CHECK(guard.screen_triangles < exact.screen_triangles);
    CHECK(guard.cut_by[0] >= exact.cut_by[0]);  // near always cuts; of some the sides then leave nothing
    CHECK(guard.trivially_rejected == exact.trivially_rejected);
    for (const Counters& c : {exact, guard}) {
      CHECK(c.triangles == c.not_finite + c.culled + c.trivially_rejected + c.trivially_accepted + c.clipped +
                               c.clipped_away);
    }
  }
}

TEST_CASE("under each policy all methods, instruction sets and threads give one answer") {
  const Scene scene = random_triangles(4, 300);
  for (const ClipPolicy policy : {ClipPolicy::guard, ClipPolicy::exact}) {
    for (const std::uint64_t seed : {11u, 12u}) {
      const Camera camera = inside(seed);
      RenderSettings settings = settings_of(policy);
      settings.visibility = VisibilityMethod::scanline;
      const Picture expected = render(scene, camera, settings);
      settings.visibility = VisibilityMethod::zbuffer;
      for (const Isa isa : available_isas()) {
        for (const int threads : {1, 2, 7}) {
          settings.isa = isa;
          settings.threads = threads;
          CAPTURE(name_of(isa));
          const Picture actual = render(scene, camera, settings);
          CHECK(same_answer(actual, expected));
          CHECK(actual.counters.clipped == expected.counters.clipped);
          CHECK(actual.counters.trivially_accepted == expected.counters.trivially_accepted);
          CHECK(actual.counters.reversed == expected.counters.reversed);
        }
      }
    }
  }
}

TEST_CASE("the widest pictures have no guard band beyond them, and wide ones a small one") {
  const Scene scene = random_triangles(5, 100);
  for (const int width : {32768, 20000, 16384, 9000}) {
    RenderSettings settings = settings_of(ClipPolicy::guard, width, 4);
    const Picture vector = render(scene, inside(21), settings);
    settings.visibility = VisibilityMethod::scanline;
    const Picture scanline = render(scene, inside(21), settings);
    settings.visibility = VisibilityMethod::zbuffer;
    settings.isa = Isa::reference;
    CHECK(vector.coverage() > 0.0);
    CHECK(same_answer(vector, scanline));
    CHECK(same_answer(vector, render(scene, inside(21), settings)));
  }
}

TEST_CASE("a crop equals the part of the whole under either policy") {
  const Scene scene = random_triangles(6, 200);
  for (const ClipPolicy policy : {ClipPolicy::guard, ClipPolicy::exact}) {
    RenderSettings settings = settings_of(policy);
    const Picture whole = render(scene, inside(31), settings);
    settings.crop = Rect{17, 23, 40, 30};
    const Picture part = render(scene, inside(31), settings);
    bool same = true;
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        same = same && part.triangle_id.at(x, y) == whole.triangle_id.at(17 + x, 23 + y) &&
               part.depth.at(x, y) == whole.depth.at(17 + x, 23 + y);
      }
    }
    CHECK(same);
  }
}
