#pragma once

#include <vector>

#include "kd_tree.hpp"

namespace velum {

/// The surface-area heuristic, greedily from the root down; see KdSettings for the choices. Exact, over all
/// planes at the sides of boxes, it takes O(n log n): the sides are sorted once and kept in order from node
/// to node. Source: Wald & Havran 2006, "On building fast kd-Trees for Ray Tracing, and on doing that in O(N
/// log N)". The article "Acceleration Structures" of the lectures sorts anew in every node (O(n log² n)), and
/// tests axis 0 for flatness, whichever axis was divided.
/// @param items  of the triangles that can be hit; not empty
/// @param pad    by so much they reach into more cells than their boxes say
KdArrays build_kd_tree(const TriangleSet& triangles, std::vector<BoxedItem> items, double pad,
                       const KdSettings& settings);

/// The longest path that settings allow for n items.
int kd_depth(const KdSettings& settings, std::size_t n);

}  // namespace velum
