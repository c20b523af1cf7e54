#pragma once

#include <vector>

#include "../../base/isa.hpp"
#include "../triangle_set.hpp"
#include "wide_nodes.hpp"

namespace velum {

/// A hierarchy of boxes with eight children per node.
struct WideTree {
  std::vector<WideNode> nodes;
  std::vector<TriangleBlock> blocks;
  WideReference root{};

  bool is_empty() const { return blocks.empty(); }
  std::size_t memory() const {
    return nodes.size() * sizeof(WideNode) + blocks.size() * sizeof(TriangleBlock);
  }
  WideTreeView view() const { return {nodes.data(), blocks.data(), root}; }
};

/// Builds one from the top by the binned surface-area heuristic: of a node's children the one with the
/// largest surface is divided until there are eight (Wald, Benthin & Boulos 2008, "Getting Rid of Packets").
/// Triangles with a vertex that is not finite are left out. The tree is the same with every isa.
WideTree build_wide_tree(const TriangleSet& triangles, Isa isa);

}  // namespace velum
