#pragma once

#include <glm/common.hpp>

#include "../search.hpp"
#include "kd_ropes.hpp"

namespace velum {

/// The ways of a ray through a kd-tree; see KdWalk. Each hands the search the triangles of all cells that the
/// ray enters no later than its limit.
/// @pre the ray is usable and meets `bounds`, which hold all triangles; the tree is not empty

void walk_by_stack(const KdArrays& tree, const Aabb& bounds, Search& search);
void walk_by_recursion(const KdArrays& tree, const Aabb& bounds, Search& search);

/// Without a stack. @return false, having done nothing, for rays that come from so far away that their place
/// is known less well than the tree's pad says, and trees without a pad
bool walk_by_ropes(const KdArrays& tree, const KdRopes& ropes, const Aabb& bounds, Search& search);

/// Which nodes may still have what the search wants: those that the ray is in between the beginning of its
/// range and the search's limit. Where triangles were split, the ray can hit one (at a t that rounds badly,
/// where it grazes the triangle) as far from the cells that have it as the triangle's box is long, but no
/// farther. So much longer a node is wanted, on both sides; see KdArrays::reaches.
class KdWanted {
 public:
  KdWanted(const KdArrays& tree, const Search& search)
      : reaches_(tree.reaches.empty() ? nullptr : tree.reaches.data()),
        search_(search),
        margin_(2.0 * search.ray.margin),
        per_length_(glm::abs(search.ray.scale_z) * (1.0 + 0x1.0p-20)) {}

  bool operator()(std::uint32_t node, const Interval& inside) const {
    if (reaches_ == nullptr) return inside.lower <= search_.limit();
    const double slack = this->slack(node);
    return inside.lower <= search_.limit() + slack && inside.upper >= search_.ray.range.lower - slack;
  }
  /// How much longer a node is wanted, in t.
  double slack(std::uint32_t node) const {
    return reaches_ == nullptr ? 0.0 : (static_cast<double>(reaches_[node]) + margin_) * per_length_;
  }
  /// The part of the ray in the root's cell. @param bounds  around all triangles
  Interval root(const Aabb& bounds) const {
    const Interval range = search_.ray.range;
    return intersect(search_.ray.through(bounds.lower, bounds.upper),
                     {range.lower - slack(0), range.upper + slack(0)});
  }
  bool asks_every_node() const { return reaches_ != nullptr; }

 private:
  const float* reaches_;
  const Search& search_;
  double margin_, per_length_;
};

/// Tests the triangles of a leaf that the ray has not met yet.
void test_leaf(const KdArrays& tree, const KdNode& leaf, Search& search, Mailboxes& mailboxes);

}  // namespace velum
