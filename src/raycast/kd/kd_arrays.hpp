#pragma once

#include <cstdint>
#include <vector>

#include "../triangle_set.hpp"

namespace velum {

/// A node of the flat array, 8 bytes; the left child of an inner node is the next one.
struct KdNode {
  std::uint32_t word = 3;  ///< lowest two bits: the axis, 3 of a leaf. Above: the right child; leaf: first id
  union {
    float split = 0.0f;
    std::uint32_t count;  ///< leaf: how many ids
  };

  bool is_leaf() const { return (word & 3u) == 3u; }
  int axis() const { return static_cast<int>(word & 3u); }
  std::uint32_t index() const { return word >> 2; }
};

/// All there is to a kd-tree, in arrays that can be written to a file as they are.
struct KdArrays {
  /// No path from the root is longer.
  static constexpr int most_depth = 60;

  std::vector<KdNode> nodes;       ///< in preorder; nodes[0] is the root, none for no triangles
  std::vector<std::uint32_t> ids;  ///< of the leaves, one after the other
  /// Of each node, where triangles were split: the longest side of the box of any triangle below it that has
  /// left out cells its box reaches into. So far a hit can lie from the cells that have the triangle. Or
  /// none.
  std::vector<float> reaches;
  Box cell;          ///< the root's
  double pad = 0.0;  ///< by so much more than their boxes triangles reach into cells; ropes need it

  std::size_t memory() const {
    return nodes.size() * sizeof(KdNode) + ids.size() * sizeof(ids[0]) + reaches.size() * sizeof(reaches[0]);
  }
};

}  // namespace velum
