#pragma once

#include <vector>

#include "kd_tree.hpp"

namespace velum {

/// The exact surface-area heuristic over all planes at the sides of boxes, in O(n log n): the sides are
/// sorted once and kept in order from node to node.
/// Source: Wald & Havran 2006, "On building fast kd-Trees for Ray Tracing, and on doing that in O(N log N)";
/// without clipping triangles to their cells. The article "Acceleration Structures" of the lectures sorts
/// anew in every node (O(n log² n)), and tests axis 0 for flatness, whichever axis was divided.
/// @param items  of the triangles that can be hit; not empty
KdArrays build_kd_tree(const std::vector<BoxedItem>& items, const KdSettings& settings);

/// The longest path that settings allow for n items.
int kd_depth(const KdSettings& settings, std::size_t n);

}  // namespace velum
