#include "bvh_refit.hpp"

#include "../triangle_set.hpp"

namespace velum {
namespace {

/// By id; empty for triangles that nothing can hit.
std::vector<Box> boxes_of(const TriangleSet& triangles) {
  std::vector<Box> boxes(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const glm::uvec3& t = triangles.triangles[i];
    const glm::vec3 &a = triangles.positions[t.x], &b = triangles.positions[t.y],
                    &c = triangles.positions[t.z];
    const glm::vec3 zero = (a - a) + (b - b) + (c - c);
    if (zero != glm::vec3(0.0f)) continue;
    boxes[i].include(a);
    boxes[i].include(b);
    boxes[i].include(c);
  }
  return boxes;
}

std::vector<std::uint32_t> empty_of(std::span<const Box> boxes) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].is_empty()) ids.push_back(i);
  }
  return ids;
}

}  // namespace

void refit(BvhTree& tree, std::span<const Box> boxes) {
  // Children come after their parents.
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    BvhNode& node = tree.nodes[i];
    Box box;
    if (node.is_leaf()) {
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k) box.include(boxes[tree.order[k]]);
    } else {
      for (const BvhNode& child : {tree.nodes[node.first], tree.nodes[node.first + 1]}) {
        box.include(Box{child.lower, child.upper});
      }
    }
    node.lower = box.lower;
    node.upper = box.upper;
  }
}

bool MovingBvh::update(const TriangleSet& triangles) {
  const std::vector<Box> boxes = boxes_of(triangles);
  std::vector<std::uint32_t> unplaced = empty_of(boxes);
  if (boxes.size() == triangles_ && unplaced == unplaced_) {
    refit(tree_, boxes);
    cost_ = expected_cost(tree_, settings_);
    if (cost_ <= cost_when_built_ * most_growth_) return false;
  }
  triangles_ = boxes.size();
  unplaced_ = std::move(unplaced);
  build(boxes);
  return true;
}

void MovingBvh::build(std::span<const Box> boxes) {
  std::vector<BoxedItem> items;
  items.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].is_empty()) items.push_back({boxes[i], i});
  }
  tree_ = build_bvh(std::move(items), settings_);
  cost_ = cost_when_built_ = expected_cost(tree_, settings_);
}

}  // namespace velum
