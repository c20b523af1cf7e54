#include <doctest/doctest.h>

#include <algorithm>

#include "random_scenes.hpp"
#include "raycast/brute_force/brute_force.hpp"
#include "raycast/kd/kd_packet.hpp"
#include "raycast/kd/kd_split.hpp"
#include "raycast/kd/kd_tree.hpp"

using namespace velum;

namespace {

RandomTriangles cloud(int count, double size, std::uint64_t seed = 41) {
  Random random{seed};
  RandomTriangles triangles;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 a(random_point(random));
    triangles.add(a, a + glm::vec3(random_point(random, size)), a + glm::vec3(random_point(random, size)));
  }
  return triangles;
}

CastCounters cost_of(const Accelerator& structure, int rays) {
  CastCounters counters;
  Random random{42};
  for (int i = 0; i < rays; ++i) structure.first_hit(random_ray(random), {}, counters);
  return counters;
}

/// The cell of each node.
std::vector<Box> cells_of(const KdArrays& tree) {
  std::vector<Box> cells(tree.nodes.size());
  cells[0] = tree.cell;
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const KdNode& node = tree.nodes[i];
    if (node.is_leaf()) continue;
    cells[i + 1] = cells[node.index()] = cells[i];
    cells[i + 1].upper[node.axis()] = cells[node.index()].lower[node.axis()] = node.split;
  }
  return cells;
}

/// What the surface-area heuristic expects of a tree, by its definition.
double expected_cost(const KdArrays& tree, const KdSettings& settings = {}) {
  const std::vector<Box> cells = cells_of(tree);
  double sum = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const KdNode& node = tree.nodes[i];
    const double cost = node.is_leaf() ? settings.triangle_cost * node.count : settings.step_cost;
    sum += cost * cells[i].half_area();
  }
  return sum / tree.cell.half_area();
}

/// Long and thin, at random angles.
RandomTriangles needles(int count) {
  Random random{44};
  RandomTriangles triangles;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 a(random_point(random)), b(random_point(random));
    triangles.add(a, b, b + glm::vec3(random_point(random, 0.02)));
  }
  return triangles;
}

}  // namespace

TEST_CASE("a kd-tree from samples costs little more than an exact one, and few triangles are exact") {
  const RandomTriangles triangles = cloud(5000, 0.1);
  const double exact = expected_cost(KdTree(triangles.set()).arrays());
  const double halves = expected_cost(KdTree(triangles.set(), {.samples = 2}).arrays());
  const double sampled = expected_cost(KdTree(triangles.set(), {.samples = 16}).arrays());
  CAPTURE(exact);
  CAPTURE(halves);
  CHECK(sampled < 1.05 * exact);
  CHECK(sampled < halves);
  const RandomTriangles few = cloud(100, 0.1);
  const KdArrays one = KdTree(few.set()).arrays(), other = KdTree(few.set(), {.samples = 101}).arrays();
  CHECK(one.ids == other.ids);
  CHECK(one.nodes.size() == other.nodes.size());
}

TEST_CASE("samples go where the counts change") {
  // Items in two clusters at the ends of a long cell: even samples see neither's inside.
  std::vector<BoxedItem> items;
  std::vector<std::uint32_t> all;
  Random random{45};
  for (std::uint32_t i = 0; i < 400; ++i) {
    const auto x = static_cast<float>(i % 2 == 0 ? random.uniform(0.0, 1.0) : random.uniform(99.0, 100.0));
    items.push_back({{{x, 0, 0}, {x + 0.001f, 1, 1}}, i});
    all.push_back(i);
  }
  const Box cell{{0, 0, 0}, {101, 1, 1}};
  const KdPlane plane = sampled_plane(items, all, cell, {.samples = 16});
  CHECK(plane.axis == 0);
  const bool is_beside_a_cluster =
      (plane.place > 0.9f && plane.place < 4.0f) || (plane.place > 96.0f && plane.place < 99.1f);
  CAPTURE(plane.place);
  CHECK(is_beside_a_cluster);
}

TEST_CASE("split triangles are only in cells that they reach into") {
  const RandomTriangles triangles = needles(200);
  const KdArrays referenced = KdTree(triangles.set()).arrays();
  const KdArrays split = KdTree(triangles.set(), {.cut = KdCut::split}).arrays();
  CHECK(expected_cost(split) < 0.5 * expected_cost(referenced));
  CHECK(referenced.reaches.empty());
  REQUIRE(split.reaches.size() == split.nodes.size());
  const std::vector<Box> cells = cells_of(split);
  std::size_t checked = 0, missing = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const KdNode& leaf = split.nodes[i];
    if (!leaf.is_leaf()) continue;
    const auto begin = split.ids.begin() + leaf.index(), end = begin + leaf.count;
    for (std::uint32_t id = 0; id < triangles.set().size(); ++id) {
      const bool is_there = std::find(begin, end, id) != end;
      const bool touches = box_of_part(triangles.set()[id], cells[i], 1e-9).has_value();
      const bool reaches_inside = box_of_part(triangles.set()[id], cells[i], -1e-9).has_value();
      CHECK((!is_there || touches));
      missing += !is_there && reaches_inside;
      checked += is_there;
    }
  }
  CHECK(missing == 0);
  CHECK(checked == split.ids.size());
}

TEST_CASE("the box of a triangle's part in a cell") {
  const Triangle triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto box = box_of_part(triangle, {{1, 1, -1}, {9, 9, 1}}, 0.0);
  REQUIRE(box.has_value());
  CHECK(box->lower.x == doctest::Approx(1.0));
  CHECK(box->upper.x == doctest::Approx(3.0));
  CHECK(box->upper.y == doctest::Approx(3.0));
  CHECK(box->lower.z <= 0.0f);
  CHECK(box->upper.z >= 0.0f);
  CHECK_FALSE(box_of_part(triangle, {{3, 3, -1}, {9, 9, 1}}, 0.0).has_value());  // only its box is there
  CHECK_FALSE(box_of_part(triangle, {{1, 1, 1}, {9, 9, 2}}, 0.0).has_value());
}

TEST_CASE("a kd-tree refers to its triangles a bounded number of times") {
  const RandomTriangles soup = cloud(400, 2.0);
  for (const KdCut cut : {KdCut::referenced, KdCut::split}) {
    for (const int samples : {0, 8}) {
      const KdTree tree(soup.set(), {.cut = cut, .samples = samples, .most_references = 5.0});
      CHECK(tree.arrays().ids.size() <= 2000);
      CHECK(tree.arrays().ids.size() > 1000);
    }
  }
}

TEST_CASE("a split triangle is hit by rays that graze it, as a whole one is") {
  Random random{46};
  const RandomTriangles triangles = needles(60);
  const BruteForce oracle(triangles.set());
  const KdTree split(triangles.set(), {.triangle_cost = 10.0, .cut = KdCut::split});
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Triangle t = triangles.set()[static_cast<std::uint32_t>(random.below(60))];
    const glm::dvec3 p = t.a + (t.b - t.a) * random.uniform(), q = t.a + (t.c - t.a) * random.uniform();
    const Ray ray{p, q - p};
    CastCounters counters;
    const RayHit any = oracle.first_hit(ray, {}, counters);
    if (!any.is_hit()) continue;
    ++hits;
    const Interval just{any.t, any.t};
    CHECK(split.first_hit(ray, {}, counters).triangle == any.triangle);
    CHECK(split.first_hit(ray, just, counters).triangle == any.triangle);
  }
  CHECK(hits > 1000);
}

TEST_CASE("a rope leads to the smallest subtree that holds all beyond a side of a cell") {
  const RandomTriangles triangles = cloud(300, 0.2);
  const KdTree tree(triangles.set(), {.walk = KdWalk::ropes});
  const std::vector<Box> cells = cells_of(tree.arrays());
  int outside = 0;
  REQUIRE(tree.ropes().leaves.size() == cells.size() / 2 + 1);
  for (const RopedLeaf& leaf : tree.ropes().leaves) {
    for (int side = 0; side < 6; ++side) {
      const int axis = side / 2;
      const bool is_upper = side % 2 == 1;
      const float plane = is_upper ? leaf.cell.upper[axis] : leaf.cell.lower[axis];
      const std::uint32_t rope = leaf.ropes[static_cast<std::size_t>(side)];
      if (rope == RopedLeaf::outside) {
        ++outside;
        CHECK(plane == (is_upper ? tree.arrays().cell.upper[axis] : tree.arrays().cell.lower[axis]));
        continue;
      }
      const auto holds = [&](const Box& cell) {
        if ((is_upper ? cell.lower[axis] : cell.upper[axis]) != plane) return false;
        for (int other = 0; other < 3; ++other) {
          if (other == axis) continue;
          if (cell.lower[other] > leaf.cell.lower[other]) return false;
          if (cell.upper[other] < leaf.cell.upper[other]) return false;
        }
        return true;
      };
      CHECK(holds(cells[rope]));
      const KdNode& node = tree.nodes()[rope];
      if (node.is_leaf()) continue;
      CHECK_FALSE(holds(cells[rope + 1]));
      CHECK_FALSE(holds(cells[node.index()]));
    }
  }
  CHECK(outside > 20);
}

TEST_CASE("the ways through a kd-tree: recursion and stack visit the same, ropes fewer nodes") {
  const RandomTriangles triangles = cloud(3000, 0.05);
  const KdTree recursive(triangles.set(), {.walk = KdWalk::recursive});
  const KdTree stack(triangles.set());
  const CastCounters by_recursion = cost_of(recursive, 200), by_stack = cost_of(stack, 200);
  CHECK(by_recursion.nodes == by_stack.nodes);
  CHECK(by_recursion.tests == by_stack.tests);
  CHECK(by_recursion.mailbox == by_stack.mailbox);
  // Over the same tree: a rope spares the way down from the root's end.
  KdTree roped(triangles.set(), {.walk = KdWalk::ropes});
  const KdTree unroped(triangles.set(), roped.arrays(), KdWalk::stack);
  const CastCounters by_ropes = cost_of(roped, 200), without = cost_of(unroped, 200);
  CHECK(by_ropes.hits == without.hits);
  CHECK(by_ropes.nodes < without.nodes);
  CHECK(by_ropes.tests <= without.tests);
}

TEST_CASE("mailboxes spare a kd-tree the triangles that several cells hold") {
  const RandomTriangles triangles = cloud(300, 1.0);
  const CastCounters counters = cost_of(KdTree(triangles.set()), 200);
  CHECK(counters.mailbox > counters.tests / 4);
}

TEST_CASE("a ray by ropes along planes, through cell corners and edges is not lost and ends") {
  int hits = 0;
  // With a cell of 1 all is exact; others round, so that a corner is met before or after its planes.
  for (const float cell : {1.0f, 0.1f, 1.0f / 3.0f, 0.7f}) {
    RandomTriangles triangles;
    for (int i = 0; i < 64; ++i) {
      const glm::vec3 at(i % 4, i / 4 % 4, i / 16);
      triangles.add(at * cell, (at + glm::vec3(1, 0, 0)) * cell, (at + glm::vec3(0, 1, 1)) * cell);
    }
    const KdSettings settings{.step_cost = 0.01, .most_depth = 20, .walk = KdWalk::ropes};
    const KdTree tree(triangles.set(), settings);
    const BruteForce oracle(triangles.set());
    CHECK(tree.nodes().size() > 60);
    for (int from = 0; from < 125; ++from) {
      for (int to = 0; to < 125; ++to) {
        const glm::dvec3 p(from % 5, from / 5 % 5, from / 25), q(to % 5, to / 5 % 5, to / 25);
        const Ray ray{(p + (p - q) * 0.3) * static_cast<double>(cell), (q - p) * 0.37};
        CastCounters counters;
        const RayHit expected = oracle.first_hit(ray, {}, counters);
        const RayHit found = tree.first_hit(ray, {}, counters);
        CHECK(found.triangle == expected.triangle);
        CHECK(found.t == expected.t);
        hits += expected.is_hit();
      }
    }
  }
  CHECK(hits > 5000);
}

TEST_CASE(
    "a ray by ropes never goes back, though rounding puts its place before a plane that it has crossed") {
  Random random{48};
  RandomTriangles triangles;
  triangles.add({0, 0, 0}, {4, 0, 0}, {4, 4, 4});
  const auto inner = [](std::uint32_t right, std::uint32_t axis, float plane) {
    KdNode node;
    node.word = right << 2 | axis;
    node.split = plane;
    return node;
  };
  const auto leaf = [](std::uint32_t first) {
    KdNode node;
    node.word = first << 2 | 3u;
    node.count = 1;
    return node;
  };
  int before_both = 0;
  for (int scene = 0; scene < 100; ++scene) {
    // Two columns below y and three above: from below, a rope leads to all three. Each leaf has the triangle,
    // so that visits are counted.
    const auto x = static_cast<float>(random.uniform(1.0, 2.0)),
               y = static_cast<float>(random.uniform(1.0, 2.0));
    KdArrays columns;
    columns.nodes = {inner(4, 1, y), inner(3, 0, x), leaf(0), leaf(1), inner(8, 0, 3.0f),
                     inner(7, 0, x), leaf(2),        leaf(3), leaf(4)};
    columns.ids = {0, 0, 0, 0, 0};
    columns.cell = {{0, 0, 0}, {4, 4, 4}};
    columns.pad = 1e-6;
    const KdTree tree(triangles.set(), columns, KdWalk::ropes);
    REQUIRE_FALSE(tree.ropes().is_empty());
    for (int i = 0; i < 1000; ++i) {
      // Through an edge where four meet: from one column into the opposite one, by way of one other.
      const glm::dvec3 direction(random.uniform(0.1, 1.1), random.uniform(0.1, 1.1), 0.0);
      const glm::dvec3 edge(x, y, 2.0);
      const double far = random.uniform(0.0, 4.0);
      const Ray ray{edge - direction * far, direction};
      const double at_x = (edge.x - ray.origin.x) * (1.0 / direction.x);
      const double at_y = (edge.y - ray.origin.y) * (1.0 / direction.y);
      const glm::dvec3 place = ray.at(std::max(at_x, at_y));
      before_both += place.x < edge.x && place.y < edge.y;
      CastCounters counters;
      std::vector<RayHit> hits;
      tree.all_hits(ray, {0.0, far + 0.1}, counters, hits);
      REQUIRE(counters.tests + counters.mailbox <= 3);
    }
  }
  CHECK(before_both > 100);
}

namespace {

/// Packets of any rays find what single rays find. @return rays that went together
std::size_t compare_packets(const RandomTriangles& triangles, const std::vector<Ray>& rays,
                            const Interval& range) {
  const KdTree tree(triangles.set());
  std::vector<RayHit> found(rays.size());
  CastCounters together, alone;
  first_hits(tree, rays, range, together, found);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RayHit expected = tree.first_hit(rays[i], range, alone);
    CHECK(found[i].triangle == expected.triangle);
    CHECK(found[i].t == expected.t);
  }
  CHECK(together.hits == alone.hits);
  CHECK(together.rays == alone.rays);
  return together.nodes;
}

}  // namespace

TEST_CASE("rays in packets hit what single rays hit, and share nodes where they keep together") {
  Random random{47};
  for (int scene = 0; scene < 20; ++scene) {
    const RandomTriangles triangles = random_triangles(random, scene);
    std::vector<Ray> rays;  // three to a kind, so that some packets agree in signs and some do not
    for (int i = 0; i < 101; ++i)
      rays.push_back(i % 24 < 12 ? hard_ray(random, triangles) : random_ray(random));
    compare_packets(triangles, rays, {});
    compare_packets(triangles, rays, {0.0, 0.7});
  }
  const RandomTriangles triangles = cloud(2000, 0.1);
  std::vector<Ray> rays;
  for (int i = 0; i < 800; ++i) {
    const double x = (i % 8 + i / 8 % 10 * 8) / 80.0, y = i / 80 / 10.0;
    rays.push_back({{3.0, 2.0, 4.0}, {x - 3.5, y - 2.5, -4.0}});
  }
  CastCounters single;
  const KdTree tree(triangles.set());
  for (const Ray& ray : rays) tree.first_hit(ray, {}, single);
  CHECK(compare_packets(triangles, rays, {}) * 2 < single.nodes);
}
