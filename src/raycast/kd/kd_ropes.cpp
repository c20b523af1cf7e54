#include "kd_ropes.hpp"

namespace velum {
namespace {

/// A node on the way through the tree, with what lies beyond the sides of its cell.
struct Roped {
  std::uint32_t node;
  RopedLeaf leaf;
};

std::size_t lower_side(int axis) {
  return 2 * static_cast<std::size_t>(axis);
}

}  // namespace

std::uint32_t smallest_beyond(const KdArrays& tree, std::uint32_t node, const Box& cell, int side) {
  if (node == RopedLeaf::outside) return node;
  while (!tree.nodes[node].is_leaf()) {
    const KdNode& inner = tree.nodes[node];
    const int axis = inner.axis();
    const bool is_upper = (side & 1) != 0;
    if (axis == side / 2) {
      node = is_upper ? node + 1 : inner.index();  // the child next to the cell
    } else if (inner.split >= cell.upper[axis]) {
      node = node + 1;
    } else if (inner.split <= cell.lower[axis]) {
      node = inner.index();
    } else {
      break;
    }
  }
  return node;
}

KdRopes rope_kd_tree(const KdArrays& tree, bool optimises) {
  KdRopes result;
  if (tree.nodes.empty()) return result;
  result.leaf_of_node.resize(tree.nodes.size());
  Roped root{0, {tree.cell, {}}};
  root.leaf.ropes.fill(RopedLeaf::outside);
  std::vector<Roped> waiting{root};
  while (!waiting.empty()) {
    Roped next = waiting.back();
    waiting.pop_back();
    const KdNode& node = tree.nodes[next.node];
    if (node.is_leaf()) {
      for (int side = 0; side < 6 && optimises; ++side) {
        std::uint32_t& rope = next.leaf.ropes[static_cast<std::size_t>(side)];
        rope = smallest_beyond(tree, rope, next.leaf.cell, side);
      }
      result.leaf_of_node[next.node] = static_cast<std::uint32_t>(result.leaves.size());
      result.leaves.push_back(next.leaf);
      continue;
    }
    // The children lie beyond each other's sides at the plane; the other sides they have from above.
    Roped left = next, right = next;
    left.node = next.node + 1;
    right.node = node.index();
    left.leaf.cell.upper[node.axis()] = right.leaf.cell.lower[node.axis()] = node.split;
    left.leaf.ropes[lower_side(node.axis()) + 1] = right.node;
    right.leaf.ropes[lower_side(node.axis())] = left.node;
    waiting.push_back(right);
    waiting.push_back(left);
  }
  return result;
}

}  // namespace velum
