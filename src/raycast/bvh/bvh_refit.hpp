#pragma once

#include "bvh_build.hpp"

namespace velum {

/// The same hierarchy around items that have moved: every box anew, from the leaves up; in O(n), where a
/// build takes O(n log n). The order of the items stays, so the boxes come to overlap the more the farther
/// items move apart that were neighbours.
/// @param boxes  by item id. @pre they cover the ids of the tree
void refit(BvhTree& tree, std::span<const Box> boxes);

/// A hierarchy over triangles whose vertices move from frame to frame. It is refitted, and built anew once
/// the cost that the surface-area heuristic expects of it has grown by a factor since it was built last
/// (Lauterbach et al. 2006, "RT-DEFORM: Interactive Ray Tracing of Dynamic Scenes using BVHs", who compare
/// the boxes' volumes with their parents' instead).
class MovingBvh {
 public:
  /// @param most_growth  ≥ 1; infinity: never built anew
  explicit MovingBvh(const BvhSettings& settings = {}, double most_growth = 1.3)
      : settings_(settings), most_growth_(most_growth) {}

  /// Follows the triangles to where they lie now. Other triangles than last time (another number of them, or
  /// others that are not finite) mean a new hierarchy.
  /// @return whether it was built anew
  bool update(const TriangleSet& triangles);

  const BvhTree& tree() const { return tree_; }
  /// The expected cost of a ray that meets the root, now and when the hierarchy was built.
  double cost() const { return cost_; }
  double cost_when_built() const { return cost_when_built_; }

 private:
  void build(std::span<const Box> boxes);

  BvhSettings settings_;
  double most_growth_;
  BvhTree tree_;
  std::size_t triangles_ = 0;
  std::vector<std::uint32_t> unplaced_;  ///< triangles that no box holds
  double cost_ = 0.0;
  double cost_when_built_ = 0.0;
};

}  // namespace velum
