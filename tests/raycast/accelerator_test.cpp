#include <doctest/doctest.h>

#include <functional>
#include <memory>
#include <string>

#include "random_scenes.hpp"
#include "raycast/brute_force/bounded_brute_force.hpp"
#include "raycast/brute_force/brute_force.hpp"
#include "raycast/bvh/bvh.hpp"
#include "raycast/kd/kd_tree.hpp"
#include "raycast/space/bsp_tree.hpp"
#include "raycast/space/grid.hpp"
#include "raycast/space/octree_caster.hpp"
#include "raycast/wide/wide_bvh.hpp"
#include "spatial/convex_hull.hpp"

using namespace velum;

namespace {

struct Built {
  std::string name;
  std::unique_ptr<Accelerator> structure;
};

/// Every structure, and every rule by which one can be built.
std::vector<Built> build_all(const TriangleSet& triangles) {
  std::vector<Built> all;
  for (const AcceleratorName& name : accelerator_names()) {
    all.push_back({name.name, build_accelerator(name.kind, triangles)});
  }
  for (const BvhSplit split : {BvhSplit::median, BvhSplit::cyclic_median, BvhSplit::midpoint,
                               BvhSplit::sah_sweep, BvhSplit::agglomerative}) {
    BvhSettings settings;
    settings.split = split;
    all.push_back(
        {"bvh, rule " + std::to_string(static_cast<int>(split)), std::make_unique<Bvh>(triangles, settings)});
  }
  for (const Isa isa : available_isas()) {
    all.push_back({std::string("bvh, ") + name_of(isa), std::make_unique<WideBvh>(triangles, isa)});
  }
  all.push_back({"octree, kept",
                 std::make_unique<OctreeCaster>(triangles, OctreeOptions{OctreePlacement::kept, 2, 20})});
  all.push_back({"kd-tree, deep", std::make_unique<KdTree>(triangles, KdSettings{0.1, 4.0, 0.9, 30})});
  all.push_back(
      {"kd-tree, recursive", std::make_unique<KdTree>(triangles, KdSettings{.walk = KdWalk::recursive})});
  all.push_back({"kd-tree, ropes", std::make_unique<KdTree>(triangles, KdSettings{.walk = KdWalk::ropes})});
  all.push_back({"kd-tree, deep, ropes",
                 std::make_unique<KdTree>(triangles, KdSettings{0.1, 4.0, 0.9, 30, KdWalk::ropes})});
  const KdSettings kd_ways[] = {
      {.cut = KdCut::split},
      {.triangle_cost = 8.0, .most_depth = 12, .walk = KdWalk::recursive, .cut = KdCut::split},
      {.triangle_cost = 8.0, .most_depth = 12, .walk = KdWalk::ropes, .cut = KdCut::split},
      {.samples = 8},
      {.walk = KdWalk::ropes, .cut = KdCut::split, .samples = 16},
      {.samples = 1},
  };
  for (const KdSettings& settings : kd_ways) {
    all.push_back({"kd-tree, way " + std::to_string(&settings - kd_ways),
                   std::make_unique<KdTree>(triangles, settings)});
  }
  for (const VolumeName& name : volume_names()) {
    if (name.kind == VolumeKind::convex_hull && !has_convex_hull()) continue;
    all.push_back(
        {std::string("volume, ") + name.name, std::make_unique<BoundedBruteForce>(triangles, name.kind)});
  }
  all.push_back({"grid, coarse", std::make_unique<Grid>(triangles, GridSettings{0.5, 1, 16})});
  all.push_back({"grid, deep", std::make_unique<Grid>(triangles, GridSettings{0.7, 5, 2})});
  all.push_back({"bsp, small leaves", std::make_unique<BspTree>(triangles, BspSettings{1, 30, 40})});
  return all;
}

bool same(const RayHit& a, const RayHit& b) {
  return a.triangle == b.triangle && a.t == b.t && a.barycentric == b.barycentric;
}

struct Answers {
  RayHit first;
  bool blocked;
  std::vector<RayHit> all;

  Answers(const Accelerator& structure, const Ray& ray, const Interval& range, CastCounters& counters)
      : first(structure.first_hit(ray, range, counters)),
        blocked(structure.is_blocked(ray, range, counters)) {
    structure.all_hits(ray, range, counters, all);
  }
  bool operator==(const Answers& other) const {
    return same(first, other.first) && blocked == other.blocked &&
           std::equal(all.begin(), all.end(), other.all.begin(), other.all.end(), same);
  }
};

Interval random_range(Random& random) {
  if (random.below(3) != 0) return {0.0, std::numeric_limits<double>::infinity()};
  if (random.below(2) == 0) return {};
  const double lower = random.uniform(-1.0, 1.0);
  return {lower, lower + random.uniform(0.0, 2.0)};
}

/// Eight rays through one place, or from one place, not far from each other; some of them hard.
std::vector<ViewRay> bundle(Random& random, const RandomTriangles& triangles) {
  const Ray middle = hard_ray(random, triangles);
  const Interval range = random_range(random);
  const double spread = random.below(2) == 0 ? 0.01 : 0.2;
  const bool is_parallel = random.below(3) == 0, has_one_origin = random.below(3) == 0;
  std::vector<ViewRay> rays;
  for (int i = 0, count = random.below(20) == 0 ? 5 : 8; i < count; ++i) {
    Ray ray = middle;
    const glm::dvec3 aside = random_point(random, spread);
    if (!has_one_origin) ray.origin += aside;
    if (!is_parallel) ray.direction += random_point(random, spread) * glm::length(ray.direction);
    rays.push_back({ray, range});
  }
  if (random.below(20) == 0) rays.back() = {hard_ray(random, triangles), {0.0, 1.0}};
  return rays;
}

void compare_bundles(std::uint64_t seed, int scenes, int bundles) {
  Random random{seed};
  for (int scene = 0; scene < scenes; ++scene) {
    const RandomTriangles triangles = random_triangles(random, scene);
    const BruteForce oracle(triangles.set());
    for (const Isa isa : available_isas()) {
      const WideBvh bvh(triangles.set(), isa);
      Random rays_random{seed + static_cast<std::uint64_t>(scene)};
      for (int i = 0; i < bundles; ++i) {
        const std::vector<ViewRay> rays = bundle(rays_random, triangles);
        std::vector<RayHit> expected(rays.size()), hits(rays.size());
        CastCounters counters, of_bvh;
        oracle.first_hits(rays, expected, counters);
        bvh.first_hits(rays, hits, of_bvh);
        INFO("scene " << scene << ", bundle " << i << ", " << name_of(isa));
        CHECK(std::equal(hits.begin(), hits.end(), expected.begin(), same));
        CHECK(of_bvh.rays == rays.size());
        CHECK(of_bvh.hits == counters.hits);
      }
    }
  }
}

/// @return rays that hit something
int compare_scenes(std::uint64_t seed, int scenes, int rays) {
  Random random{seed};
  int hits = 0;
  for (int scene = 0; scene < scenes; ++scene) {
    const RandomTriangles triangles = random_triangles(random, scene);
    const BruteForce oracle(triangles.set());
    const std::vector<Built> all = build_all(triangles.set());
    for (int i = 0; i < rays; ++i) {
      const Ray ray = hard_ray(random, triangles);
      const Interval range = random_range(random);
      CastCounters counters;
      const Answers expected(oracle, ray, range, counters);
      CHECK(expected.blocked == expected.first.is_hit());
      CHECK(expected.blocked == !expected.all.empty());
      if (expected.blocked) CHECK(same(expected.all[0], expected.first));
      hits += expected.blocked;
      for (const Built& built : all) {
        INFO("seed " << seed << ", scene " << scene << ", ray " << i << ": " << built.name);
        CHECK(Answers(*built.structure, ray, range, counters) == expected);
      }
    }
  }
  return hits;
}

}  // namespace

TEST_CASE("all structures find what brute force finds in 500 scenes") {
  CHECK(compare_scenes(22, 500, 40) > 4000);
}

TEST_CASE("rays cast together hit what each hits alone in 500 scenes") {
  compare_bundles(26, 500, 60);
}

TEST_CASE("a structure over no triangles is hit by nothing") {
  CastCounters counters;
  for (const Built& built : build_all({})) {
    CAPTURE(built.name);
    CHECK_FALSE(built.structure->first_hit({{0, 0, 5}, {0, 0, -1}}, {}, counters).is_hit());
    CHECK(built.structure->bounds().is_empty());
    CHECK(built.structure->memory() == 0);
  }
}

TEST_CASE("of triangles in the same place the lowest id is hit") {
  RandomTriangles triangles;
  for (int i = 0; i < 20; ++i) triangles.add({-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1, 0.5f});
  CastCounters counters;
  for (const Built& built : build_all(triangles.set())) {
    CAPTURE(built.name);
    CHECK(built.structure->first_hit({{0, 0, 5}, {0, 0, -1}}, {}, counters).triangle == 0);
  }
}

TEST_CASE("a filter leaves triangles out") {
  RandomTriangles triangles;
  for (int i = 0; i < 20; ++i) {
    const float z = static_cast<float>(i) * 0.1f;
    triangles.add({-1, -1, z}, {1, -1, z}, {0, 1, z});
  }
  const HitFilter filter{[](const void*, std::uint32_t id) { return id < 12; }, nullptr};
  CastCounters counters;
  for (const Built& built : build_all(triangles.set())) {
    CAPTURE(built.name);
    const Ray down{{0, 0, 5}, {0, 0, -1}};
    CHECK(built.structure->first_hit(down, {}, counters).triangle == 19);
    CHECK(built.structure->first_hit(down, {}, counters, filter).triangle == 11);
    CHECK(built.structure->is_blocked(down, {0.0, 3.5}, counters));
    CHECK_FALSE(built.structure->is_blocked(down, {0.0, 3.5}, counters, filter));
    std::vector<RayHit> hits;
    built.structure->all_hits(down, {}, counters, hits, filter);
    REQUIRE(hits.size() == 12);
    for (std::uint32_t i = 0; i < 12; ++i) CHECK(hits[i].triangle == 11 - i);
  }
}

namespace {

/// Long triangles, which reach through many cells, among small ones: a ray meets a long one in a cell near
/// its beginning, hits it far from there, and something small lies between.
RandomTriangles early_out_trap(Random& random) {
  RandomTriangles triangles;
  for (int i = 0; i < 12; ++i) {
    const glm::vec3 a(random_point(random));
    triangles.add(a, a + glm::vec3(random_point(random, 2.0)), a + glm::vec3(random_point(random, 0.5)));
  }
  for (int i = 0; i < 400; ++i) {
    const glm::vec3 a(random_point(random));
    triangles.add(a, a + glm::vec3(random_point(random, 0.2)), a + glm::vec3(random_point(random, 0.2)));
  }
  return triangles;
}

void check_early_out_trap(const std::string& name) {
  Random random{26};
  const RandomTriangles triangles = early_out_trap(random);
  const BruteForce oracle(triangles.set());
  int structures = 0;
  for (const Built& built : build_all(triangles.set())) {
    if (built.name.compare(0, name.size(), name) != 0) continue;
    CAPTURE(built.name);
    ++structures;
    int wrong = 0;
    for (int i = 0; i < 300; ++i) {
      const Ray ray = random_ray(random);
      CastCounters counters;
      wrong += !same(built.structure->first_hit(ray, {}, counters), oracle.first_hit(ray, {}, counters));
    }
    CHECK(wrong == 0);
  }
  CHECK(structures > 0);
}

}  // namespace

// A hit found in a cell but lying beyond it must not end the search.
TEST_CASE("the early-out trap: uniform grid") {
  check_early_out_trap("grid");
}
TEST_CASE("the early-out trap: nested grid") {
  check_early_out_trap("nested-grid");
}
TEST_CASE("the early-out trap: octree") {
  check_early_out_trap("octree");
}
TEST_CASE("the early-out trap: bsp tree") {
  check_early_out_trap("bsp");
}
TEST_CASE("the early-out trap: kd-tree by stack") {
  check_early_out_trap("kdtree");
}
TEST_CASE("the early-out trap: kd-tree by recursion and by ropes") {
  check_early_out_trap("kd-tree");
}

TEST_CASE("structures spare intersections") {
  Random random{23};
  RandomTriangles triangles;
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 a(random_point(random));
    triangles.add(a, a + glm::vec3(random_point(random, 0.03)), a + glm::vec3(random_point(random, 0.03)));
  }
  for (const Built& built : build_all(triangles.set())) {
    CAPTURE(built.name);
    CastCounters counters;
    Random rays{24};
    for (int i = 0; i < 100; ++i) built.structure->first_hit(random_ray(rays), {}, counters);
    CHECK(counters.rays == 100);
    const bool is_divided = built.name != "brute-force" && built.name.compare(0, 6, "volume") != 0;
    if (is_divided) CHECK(counters.tests < 100 * 4000 / 4);
    if (built.name == "bvh" || built.name == "kdtree") CHECK(counters.tests < 100 * 40);
    CHECK(built.structure->memory() > 0);
  }
}
