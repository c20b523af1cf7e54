#pragma once

#include <array>

#include "kd_arrays.hpp"

namespace velum {

/// A leaf's cell, and where its six sides lead to: the smallest subtree that holds all that lies there.
/// Sides: 2·axis the lower one, 2·axis + 1 the upper one.
struct RopedLeaf {
  static constexpr std::uint32_t outside = 0xFFFFFFFFu;
  Box cell;
  std::array<std::uint32_t, 6> ropes;  ///< nodes, or `outside`
};

/// Ropes from every leaf of a kd-tree to its neighbours, so that a ray needs no stack (Popov, Günther, Seidel
/// & Slusallek 2007, "Stackless KD-Tree Traversal for High Performance GPU Ray Tracing").
struct KdRopes {
  std::vector<RopedLeaf> leaves;
  std::vector<std::uint32_t> leaf_of_node;  ///< the place in `leaves` of each leaf node

  bool is_empty() const { return leaves.empty(); }
  std::size_t memory() const {
    return leaves.size() * sizeof(RopedLeaf) + leaf_of_node.size() * sizeof(leaf_of_node[0]);
  }
};

/// @param optimises  push each rope down to the smallest subtree; otherwise it leads to the sibling of a node
///                   above, and the ray goes down from there
KdRopes rope_kd_tree(const KdArrays& tree, bool optimises = true);

/// The subtree below `node` that holds all of it that touches a side of a cell.
/// @param side  of the cell, numbered as in RopedLeaf
std::uint32_t smallest_beyond(const KdArrays& tree, std::uint32_t node, const Box& cell, int side);

}  // namespace velum
