#include "spatial/octree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "random.hpp"

using namespace velum;

namespace {

std::vector<Aabb> random_boxes(Random& random, int count, double size) {
  std::vector<Aabb> boxes(static_cast<std::size_t>(count));
  for (Aabb& box : boxes) {
    const glm::dvec3 at(random.uniform(-3, 5), random.uniform(0, 1), random.uniform(-1, 1));
    const double reach = size * random.uniform();
    box = {at, at + glm::dvec3(reach, reach * random.uniform(), reach * random.uniform())};
  }
  return boxes;
}

bool holds(const Aabb& outer, const Aabb& inner) {
  return outer.lower.x <= inner.lower.x && outer.lower.y <= inner.lower.y && outer.lower.z <= inner.lower.z &&
         outer.upper.x >= inner.upper.x && outer.upper.y >= inner.upper.y && outer.upper.z >= inner.upper.z;
}

/// Every item once, boxes around what is below, ranges that fit into each other.
void check(const Octree& tree, std::span<const Aabb> boxes, std::uint32_t leaf_size) {
  std::vector<int> seen(boxes.size(), 0);
  for (const OctreeNode& node : tree.nodes()) {
    Aabb around;
    for (std::uint32_t i = node.first; i < node.end; ++i) around.include(boxes[tree.items()[i]]);
    CHECK((around.lower == node.box.lower && around.upper == node.box.upper));
    for (std::uint32_t i = node.first; i < node.own_end; ++i) ++seen[tree.items()[i]];
    std::uint32_t at = node.own_end;
    for (std::uint32_t i = 0; i < node.child_count; ++i) {
      const OctreeNode& child = tree.nodes()[node.first_child + i];
      CHECK(child.first == at);
      CHECK(holds(node.box, child.box));
      at = child.end;
    }
    CHECK(at == node.end);
    CHECK((node.child_count > 0 || node.end - node.first <= leaf_size || tree.depth() > 20));
  }
  for (const std::uint32_t i : tree.loose()) ++seen[i];
  CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
}

}  // namespace

TEST_CASE("an octree holds every box once, pushed down or kept at intermediate levels") {
  Random random{1};
  for (const OctreePlacement placement : {OctreePlacement::pushed_down, OctreePlacement::kept}) {
    for (const int count : {1, 7, 8, 9, 500, 3000}) {
      const std::vector<Aabb> boxes = random_boxes(random, count, 0.3);
      OctreeOptions options;
      options.placement = placement;
      const Octree tree(boxes, options);
      CHECK(tree.loose().empty());
      CHECK(tree.bytes() >= tree.nodes().size() * sizeof(OctreeNode));
      if (placement == OctreePlacement::pushed_down) check(tree, boxes, options.leaf_size);
      if (placement == OctreePlacement::kept) check(tree, boxes, 0xFFFFFFFFu);
    }
  }
}

TEST_CASE("large boxes stay above the leaves when they are kept, and only then") {
  Random random{2};
  std::vector<Aabb> boxes = random_boxes(random, 400, 0.01);
  boxes.push_back({glm::dvec3(-3.0, 0.0, -1.0), glm::dvec3(5.0, 1.0, 1.0)});
  OctreeOptions options;
  options.placement = OctreePlacement::kept;
  const Octree kept(boxes, options);
  CHECK(kept.nodes()[0].own_end > kept.nodes()[0].first);
  const Octree pushed(boxes, OctreeOptions{});
  for (const OctreeNode& node : pushed.nodes()) CHECK((node.child_count == 0 || node.own_end == node.first));
}

TEST_CASE("items in one point, and items without a place, do not stop an octree") {
  std::vector<Aabb> boxes(100, Aabb{glm::dvec3(1.0), glm::dvec3(1.0)});
  boxes.push_back({glm::dvec3(2.0), glm::dvec3(2.0)});
  boxes.emplace_back();  // empty
  boxes.push_back({glm::dvec3(0.0), glm::dvec3(std::numeric_limits<double>::infinity())});
  const Octree tree(boxes, OctreeOptions{});
  CHECK((tree.loose() == std::vector<std::uint32_t>{101, 102}));
  CHECK(tree.items().size() == 101);
  CHECK(tree.nodes()[0].child_count == 2);
  CHECK(Octree({}, OctreeOptions{}).nodes().empty());
}
