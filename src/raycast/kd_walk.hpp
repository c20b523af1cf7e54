#pragma once

#include "kd_ropes.hpp"
#include "search.hpp"

namespace velum {

/// The ways of a ray through a kd-tree; see KdWalk. Each hands the search the triangles of all cells that the
/// ray enters no later than its limit.
/// @pre the ray is usable and meets `bounds`, which hold all triangles; the tree is not empty

void walk_by_stack(const KdArrays& tree, const Aabb& bounds, Search& search);
void walk_by_recursion(const KdArrays& tree, const Aabb& bounds, Search& search);

/// Without a stack. @return false, having done nothing, for rays that come from so far away that their place
/// is known less well than the tree's pad says, and trees without a pad
bool walk_by_ropes(const KdArrays& tree, const KdRopes& ropes, const Aabb& bounds, Search& search);

/// Tests the triangles of a leaf that the ray has not met yet.
void test_leaf(const KdArrays& tree, const KdNode& leaf, Search& search, Mailboxes& mailboxes);

}  // namespace velum
