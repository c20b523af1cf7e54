#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "random_scenes.hpp"
#include "raycast/brute_force/bounded_brute_force.hpp"
#include "raycast/bvh/bvh.hpp"
#include "raycast/kd/kd_tree.hpp"
#include "raycast/space/bsp_tree.hpp"
#include "raycast/space/grid.hpp"
#include "spatial/convex_hull.hpp"

using namespace velum;

namespace {

RandomTriangles small_triangles(int count, double size) {
  Random random{31};
  RandomTriangles triangles;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 a(random_point(random));
    triangles.add(a, a + glm::vec3(random_point(random, size)), a + glm::vec3(random_point(random, size)));
  }
  return triangles;
}

bool is_inside(const BvhNode& inner, const BvhNode& outer) {
  return glm::min(inner.lower, outer.lower) == outer.lower &&
         glm::max(inner.upper, outer.upper) == outer.upper;
}

const BvhSplit all_splits[] = {BvhSplit::median,    BvhSplit::cyclic_median, BvhSplit::midpoint,
                               BvhSplit::sah_sweep, BvhSplit::sah_binned,    BvhSplit::agglomerative};

}  // namespace

TEST_CASE("a bvh holds every triangle once, in boxes inside boxes") {
  const RandomTriangles triangles = small_triangles(500, 0.2);
  for (const BvhSplit split : all_splits) {
    CAPTURE(static_cast<int>(split));
    BvhSettings settings;
    settings.split = split;
    const BvhTree tree = Bvh(triangles.set(), settings).tree();
    const std::set<std::uint32_t> ids(tree.order.begin(), tree.order.end());
    CHECK(tree.order.size() == 500);
    CHECK(ids.size() == 500);
    std::size_t in_leaves = 0;
    for (const BvhNode& node : tree.nodes) {
      in_leaves += node.count;
      if (node.is_leaf()) continue;
      CHECK(is_inside(tree.nodes[node.first], node));
      CHECK(is_inside(tree.nodes[node.first + 1], node));
    }
    CHECK(in_leaves == 500);
  }
}

TEST_CASE("the surface-area heuristic expects less cost than medians, and the sweep no more than bins") {
  const RandomTriangles triangles = small_triangles(2000, 0.1);
  const auto cost = [&](BvhSplit split) {
    BvhSettings settings;
    settings.split = split;
    settings.leaf_size = 2;
    return expected_cost(Bvh(triangles.set(), settings).tree(), settings);
  };
  CHECK(cost(BvhSplit::sah_sweep) < cost(BvhSplit::cyclic_median));
  CHECK(cost(BvhSplit::cyclic_median) < cost(BvhSplit::median));
  CHECK(cost(BvhSplit::sah_binned) < cost(BvhSplit::cyclic_median));
  CHECK(cost(BvhSplit::sah_sweep) < cost(BvhSplit::sah_binned) * 1.02);
}

TEST_CASE("a node stays a leaf when dividing would cost more, T_SAH > T_P") {
  RandomTriangles triangles;  // all in one place: each child would be met as often as the node
  for (int i = 0; i < 50; ++i) triangles.add({0, 0, 0}, {1, 0, 0}, {0, 1, 1});
  for (const BvhSplit split : {BvhSplit::sah_sweep, BvhSplit::sah_binned, BvhSplit::agglomerative}) {
    BvhSettings settings;
    settings.split = split;
    CHECK(Bvh(triangles.set(), settings).tree().nodes.size() == 1);
  }
  // Two far apart: divided where a box is cheap, not where it is dear.
  RandomTriangles two;
  two.add({0, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 0.1f});
  two.add({9, 9, 9}, {9.1f, 9, 9}, {9, 9.1f, 9.1f});
  BvhSettings settings;
  CHECK(Bvh(two.set(), settings).tree().nodes.size() == 3);
  settings.box_cost = 3.0;
  CHECK(Bvh(two.set(), settings).tree().nodes.size() == 1);
}

TEST_CASE("a bvh does not depend on the order of its items") {
  const RandomTriangles triangles = small_triangles(300, 0.3);
  std::vector<BoxedItem> items;
  for (std::uint32_t i = 0; i < 300; ++i) {
    BoxedItem item;
    item.id = i;
    for (int k = 0; k < 3; ++k) item.box.include(triangles.positions[triangles.triangles[i][k]]);
    items.push_back(item);
  }
  for (const BvhSplit split : all_splits) {
    BvhSettings settings;
    settings.split = split;
    const BvhTree tree = build_bvh(items, settings);
    std::reverse(items.begin(), items.end());
    CHECK(build_bvh(items, settings).order == tree.order);
  }
}

TEST_CASE("a kd-tree refers to every triangle, cuts empty space off, and keeps 8 bytes a node") {
  const RandomTriangles triangles = small_triangles(800, 0.1);
  const KdTree tree(triangles.set());
  CHECK(sizeof(KdNode) == 8);
  std::size_t leaves = 0, empty = 0;
  for (const KdNode& node : tree.nodes()) {
    leaves += node.is_leaf();
    empty += node.is_leaf() && node.count == 0;
  }
  CHECK(leaves == tree.nodes().size() / 2 + 1);
  CHECK(empty > 10);
  KdSettings no_bonus;
  no_bonus.empty_bonus = 0.0;
  no_bonus.triangle_cost = 0.001;
  CHECK(KdTree(triangles.set(), no_bonus).nodes().size() == 1);  // nothing is worth a step
}

TEST_CASE("nested grids help where a ball lies in a stadium") {
  RandomTriangles triangles = small_triangles(3000, 0.1);
  for (glm::vec3& p : triangles.positions) p *= 0.01f;  // the ball
  triangles.add({-50, -50, -1}, {50, -50, -1}, {0, 80, -1});
  const auto tests = [&](const GridSettings& settings) {
    const Grid grid(triangles.set(), settings);
    CastCounters counters;
    Random random{32};
    for (int i = 0; i < 200; ++i) {
      const glm::dvec3 origin = random_point(random, 0.05);
      grid.first_hit({origin, random_point(random, 0.01) - origin}, {0.0, 1e9}, counters);
    }
    return counters.tests;
  };
  CHECK(tests({1.0, 3, 16}) * 10 < tests({3.0, 1, 16}));
}

TEST_CASE("memory of grids grows with the number of triangles, also where all are as large as the grid") {
  for (const std::size_t n : {1, 1000}) {
    RandomTriangles triangles;
    for (std::size_t i = 0; i < n; ++i) triangles.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0.3f});
    for (const GridSettings& settings : {GridSettings{}, GridSettings{1.0, 3, 16}}) {
      const Grid grid(triangles.set(), settings);
      CHECK(grid.memory() <= 4096 + 4 * 4 * (32 * n + 1024) + 4 * 8 * (32 * n + 1024));
      CastCounters counters;
      CHECK(grid.first_hit({{0.3, 0.4, 5}, {0, 0, -1}}, {0.0, 100.0}, counters).triangle == 0);
    }
  }
}

TEST_CASE("a point of a bsp tree is found in one cell, the same all over the cell") {
  RandomTriangles cube;  // the three planes through 0 give eight cells
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 a(-1.0f), b(1.0f), c(1.0f);
    a[axis] = b[axis] = c[axis] = 0.0f;
    b[(axis + 1) % 3] = -1.0f;
    cube.add(a, b, c);
  }
  const BspTree tree(cube.set(), {0, 10, 10});
  CHECK(tree.cell_count() == 8);
  std::set<std::uint32_t> cells;
  Random random{33};
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : -1);
    const std::uint32_t cell = tree.cell_of(corner);
    cells.insert(cell);
    for (int k = 0; k < 10; ++k) CHECK(tree.cell_of(corner * random.uniform(0.01, 1.0)) == cell);
  }
  CHECK(cells.size() == 8);
}

TEST_CASE("lines meet one bounding volume inside another as often as their areas say") {
  RandomTriangles triangles = small_triangles(200, 0.1);
  for (glm::vec3& p : triangles.positions) p = glm::vec3(p.x, 0.3f * p.y + 0.8f * p.x, 0.5f * p.z);
  Aabb bounds;
  for (const glm::vec3& p : triangles.positions) bounds.include(glm::dvec3(p));
  const double radius = 0.5 * glm::length(bounds.size());
  for (const VolumeName& name : volume_names()) {
    if (name.kind == VolumeKind::convex_hull && !has_convex_hull()) continue;
    CAPTURE(std::string(name.name));
    const BoundingVolume volume = bounding_volume(name.kind, triangles.positions);
    // Lines in every direction through every place of a disc across it that hides all.
    Random random{34};
    int met = 0;
    constexpr int lines = 20000;
    const double reach = 1.5 * radius;
    for (int i = 0; i < lines; ++i) {
      glm::dvec3 direction(0.0);
      do direction = random_point(random);
      while (glm::dot(direction, direction) > 1.0 || glm::dot(direction, direction) < 0.01);
      const glm::dvec3 n = glm::normalize(direction);
      const glm::dvec3 other = std::fabs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
      const glm::dvec3 u = glm::normalize(glm::cross(n, other)), v = glm::cross(n, u);
      const glm::dvec3 through =
          bounds.centre() + u * random.uniform(-reach, reach) + v * random.uniform(-reach, reach);
      const PreparedRay ray({through - n * (3.0 * radius), direction}, {}, bounds);
      met += !interval_inside(ray, volume).is_empty();
    }
    // A convex volume's shadow has a quarter of its surface, on average over all directions (Cauchy).
    const double expected = volume.area / 4.0 / (4.0 * reach * reach);
    CHECK(static_cast<double>(met) / lines == doctest::Approx(expected).epsilon(0.03));
  }
}

TEST_CASE("one bounding volume: a ray that misses it costs no test, others all") {
  const RandomTriangles triangles = small_triangles(50, 0.1);
  const BoundedBruteForce ball(triangles.set(), VolumeKind::sphere), box(triangles.set(), VolumeKind::aabb);
  CastCounters by_ball, by_box;
  const glm::dvec3 corner = box.bounds().upper;
  const Ray past{{corner.x - 0.01, corner.y - 0.01, 5.0}, {0, 0, -1}};  // inside the box only
  ball.first_hit(past, {}, by_ball);
  box.first_hit(past, {}, by_box);
  CHECK(by_box.tests == 50);
  CHECK(by_ball.tests ==
        (interval_inside(PreparedRay(past, {}, box.bounds()), ball.volume()).is_empty() ? 0 : 50));
}
