#pragma once

#include <utility>

#include "../accelerator.hpp"
#include "bvh_build.hpp"

namespace velum {

/// A bounding volume hierarchy over the triangles of a mesh (Rubin & Whitted 1980; the lecture "Raytracing").
class Bvh final : public Accelerator {
 public:
  explicit Bvh(const TriangleSet& triangles, const BvhSettings& settings = {});
  /// @param tree  over these triangles as they lie, e.g. MovingBvh::tree()
  Bvh(const TriangleSet& triangles, BvhTree tree) : Accelerator(triangles), tree_(std::move(tree)) {}
  std::size_t memory() const override { return tree_.memory(); }
  const BvhTree& tree() const { return tree_; }

 private:
  void traverse(Search& search) const override;
  BvhTree tree_;
};

}  // namespace velum
