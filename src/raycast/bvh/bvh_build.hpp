#pragma once

#include <span>
#include <vector>

#include "bvh_tree.hpp"

namespace velum {

/// How a set of items is divided in two. The lecture "Raytracing" shows all but the last, which starts from
/// the items instead of from the root.
enum class BvhSplit { median, cyclic_median, midpoint, sah_sweep, sah_binned, agglomerative };

struct BvhSettings {
  BvhSplit split = BvhSplit::sah_binned;
  // The expected cost of a ray that meets a node: T_P = n·c_P as a leaf; divided,
  // T_SAH = c_BV + (p_L·n_L + p_R·n_R)·c_P with p the share of the surface. A node stays a leaf if T_SAH >
  // T_P.
  double box_cost = 1.0;        ///< c_BV
  double triangle_cost = 1.0;   ///< c_P
  std::uint32_t leaf_size = 4;  ///< rules without cost divide until so many items are left
  int median_axis = 0;          ///< of BvhSplit::median
};

/// @param items  any order; distinct ids. The tree does not depend on the order in which they are given
BvhTree build_bvh(std::vector<BoxedItem> items, const BvhSettings& settings);

/// The expected cost of a ray that meets the root, by the surface-area heuristic; 0 for no nodes.
double expected_cost(const BvhTree& tree, const BvhSettings& settings);

// The rules: each puts the items of the left child first.

/// What a rule is given: some items, at least two, and the place of their node.
struct BvhTask {
  std::span<BoxedItem> items;
  Box box;
  int depth = 0;
};

/// @return how many items go left, 1 … n-1; or 0: the node stays a leaf
using BvhRule = std::size_t (*)(const BvhTask& task, const BvhSettings& settings);

/// Half of the items by their centres along BvhSettings::median_axis.
std::size_t split_at_median(const BvhTask& task, const BvhSettings& settings);
/// The same, x, y and z in turn.
std::size_t split_at_cyclic_median(const BvhTask& task, const BvhSettings& settings);
/// What lies left and right of the middle of the box's longest side; where one is empty, the median.
std::size_t split_at_midpoint(const BvhTask& task, const BvhSettings& settings);
/// The cheapest of all 3·(n-1) divisions of the items sorted by centre (MacDonald & Booth 1990, "Heuristics
/// for Ray Tracing Using Space Subdivision").
std::size_t split_by_sweep(const BvhTask& task, const BvhSettings& settings);
/// The cheapest of the divisions between 16 bins per axis (Wald 2007, "On fast Construction of SAH-based
/// Bounding Volume Hierarchies").
std::size_t split_by_bins(const BvhTask& task, const BvhSettings& settings);

/// From the bottom up: neighbours along a curve through space are joined, of all near ones those with the
/// smallest common box (Meister & Bittner 2018, "Parallel Locally-Ordered Clustering").
BvhTree build_agglomerative(std::vector<BoxedItem> items, const BvhSettings& settings);

}  // namespace velum
