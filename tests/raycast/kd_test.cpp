#include <doctest/doctest.h>

#include <algorithm>

#include "random_scenes.hpp"
#include "raycast/brute_force.hpp"
#include "raycast/kd_tree.hpp"

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

}  // namespace

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
  RandomTriangles triangles;  // unit cells whose corners lie on whole numbers
  for (int i = 0; i < 64; ++i) {
    const glm::vec3 at(i % 4, i / 4 % 4, i / 16);
    triangles.add(at, at + glm::vec3(1, 0, 0), at + glm::vec3(0, 1, 1));
  }
  KdSettings settings{.step_cost = 0.01, .most_depth = 20, .walk = KdWalk::ropes};
  const KdTree tree(triangles.set(), settings);
  const BruteForce oracle(triangles.set());
  CHECK(tree.nodes().size() > 60);
  int hits = 0;
  for (int from = 0; from < 125; ++from) {
    for (int to = 0; to < 125; ++to) {
      const glm::dvec3 p(from % 5, from / 5 % 5, from / 25), q(to % 5, to / 5 % 5, to / 25);
      for (const glm::dvec3& back : {glm::dvec3(0.0), (p - q) * 0.5}) {
        CastCounters counters;
        const Ray ray{p + back, q - p};
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
