#pragma once

#include "../../spatial/octree.hpp"
#include "../accelerator.hpp"

namespace velum {

/// Rays through an octree over the triangles' boxes. Its nodes have tight boxes, and each triangle is in one
/// node only (at an intermediate level, or pushed down), so children may overlap and no mailboxes are needed.
class OctreeCaster final : public Accelerator {
 public:
  explicit OctreeCaster(const TriangleSet& triangles, const OctreeOptions& options = {});
  std::size_t memory() const override { return tree_.bytes(); }
  const Octree& tree() const { return tree_; }

 private:
  void traverse(Search& search) const override;
  Octree tree_;
};

}  // namespace velum
