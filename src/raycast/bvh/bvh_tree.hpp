#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../intersection/prepared_ray.hpp"
#include "../ray_hit.hpp"
#include "../triangle_set.hpp"

namespace velum {

/// A box around what hangs below; 32 bytes.
struct BvhNode {
  glm::vec3 lower{0.0f};
  std::uint32_t first = 0;  ///< leaf: place in BvhTree::order; inner: the left child, the right one follows
  glm::vec3 upper{0.0f};
  std::uint32_t count = 0;  ///< leaf: its items; inner: 0

  bool is_leaf() const { return count != 0; }
};

/// A hierarchy of boxes over items; every item is in one leaf. nodes[0] is the root; none for no items.
struct BvhTree {
  /// No path from the root is longer.
  static constexpr int most_depth = 90;

  std::vector<BvhNode> nodes;
  std::vector<std::uint32_t> order;  ///< item ids, leaf after leaf

  std::size_t memory() const { return nodes.size() * sizeof(BvhNode) + order.size() * sizeof(order[0]); }

  /// Visits the leaves that a ray goes into, nearer boxes first: of two children the one that is entered
  /// first, the other only if it is not entered after limit().
  /// @param limit  () → the largest t that is still of interest
  /// @param leaf   (ids) → whether to go on
  template <typename Limit, typename Leaf>
  void traverse(const PreparedRay& ray, CastCounters& counters, const Limit& limit, const Leaf& leaf) const;
};

template <typename Limit, typename Leaf>
void BvhTree::traverse(const PreparedRay& ray, CastCounters& counters, const Limit& limit,
                       const Leaf& leaf) const {
  struct Waiting {
    std::uint32_t node;
    double entry;
  };
  std::array<Waiting, most_depth> stack;
  std::size_t waiting = 0;
  if (nodes.empty()) return;
  std::uint32_t current = 0;
  for (;;) {
    const BvhNode& node = nodes[current];
    ++counters.nodes;
    bool descends = false;
    if (node.is_leaf()) {
      if (!leaf(std::span<const std::uint32_t>(order).subspan(node.first, node.count))) return;
    } else {
      const auto visit = [&](std::uint32_t child) {
        const BvhNode& box = nodes[child];
        Interval inside = ray.through(box.lower, box.upper);
        inside.lower = inside.lower > ray.range.lower ? inside.lower : ray.range.lower;
        return inside.lower <= inside.upper && inside.lower <= limit() ? inside : Interval::empty();
      };
      counters.boxes += 2;
      const Interval left = visit(node.first);
      const Interval right = visit(node.first + 1);
      const bool right_first = right.lower < left.lower;
      const Interval& farther = right_first ? left : right;
      descends = !left.is_empty() || !right.is_empty();
      current = node.first + (right_first ? 1u : 0u);
      if (!farther.is_empty()) stack[waiting++] = {node.first + (right_first ? 0u : 1u), farther.lower};
    }
    while (!descends) {
      if (waiting == 0) return;
      const Waiting& next = stack[--waiting];
      descends = next.entry <= limit();
      current = next.node;
    }
  }
}

}  // namespace velum
