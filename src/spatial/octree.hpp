#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../base/aabb.hpp"

namespace velum {

/// What becomes of an item whose box lies across the middle planes of a cube.
enum class OctreePlacement {
  pushed_down,  ///< it goes to the child that holds its box's centre; boxes of children may then overlap
  kept,         ///< it stays at that intermediate level (Greene, Kass & Miller 1993)
};

struct OctreeOptions {
  OctreePlacement placement = OctreePlacement::pushed_down;
  std::uint32_t leaf_size = 8;  ///< cubes with more items are divided
  int most_levels = 24;         ///< … but no further than this: items may lie in one point
};

/// A cube that holds items. Its box is the tight one around all items of its subtree.
struct OctreeNode {
  Aabb box;
  std::uint32_t first_child = 0;  ///< its children are neighbours
  std::uint32_t child_count = 0;  ///< 1 … 8, or 0 for a leaf
  std::uint32_t first = 0;        ///< items first … own_end-1 are its own,
  std::uint32_t own_end = 0;      ///< own_end … end-1 those of its children's subtrees
  std::uint32_t end = 0;
};

/// An octree over boxes: a cube around all, divided in eight again and again. Cubes without items have no
/// node, and a cube all of whose items are in one child has none either.
class Octree {
 public:
  Octree() = default;
  /// Items are numbered as the boxes are. Boxes that are empty or not finite have no place in it, see
  /// loose().
  Octree(std::span<const Aabb> boxes, const OctreeOptions& options);

  /// Node 0 is the root; empty for no items. Children come after their parents.
  const std::vector<OctreeNode>& nodes() const { return nodes_; }
  /// The items in the order that the nodes' ranges are about: each subtree's are neighbours.
  const std::vector<std::uint32_t>& items() const { return items_; }
  /// Items without a place, in their order.
  const std::vector<std::uint32_t>& loose() const { return loose_; }
  /// Nodes from the root to the deepest leaf, both counted.
  int depth() const { return depth_; }
  /// Memory that it holds, bytes.
  std::size_t bytes() const;

 private:
  struct Builder;
  std::vector<OctreeNode> nodes_;
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> loose_;
  int depth_ = 0;
};

}  // namespace velum
