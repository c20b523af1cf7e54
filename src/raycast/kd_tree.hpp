#pragma once

#include "accelerator.hpp"

namespace velum {

/// A node of the flat array, 8 bytes; the left child of an inner node is the next one.
struct KdNode {
  std::uint32_t word = 3;  ///< lowest two bits: the axis, 3 of a leaf. Above: the right child; leaf: first id
  union {
    float split = 0.0f;
    std::uint32_t count;  ///< leaf: how many ids
  };

  bool is_leaf() const { return (word & 3u) == 3u; }
  int axis() const { return static_cast<int>(word & 3u); }
  std::uint32_t index() const { return word >> 2; }
};

struct KdSettings {
  double step_cost = 1.0;      ///< of going on to a child
  double triangle_cost = 1.5;  ///< of one intersection
  double empty_bonus = 0.2;    ///< by this share a split is cheaper that cuts empty space off
  int most_depth = 0;          ///< 0: 8 + 1.3·log2(n)
};

/// A kd-tree: space is divided by planes across an axis; triangles that a plane cuts are referenced on both
/// sides. A triangle that is met in one cell can be hit in another one farther on, so a hit ends the search
/// only where nothing nearer can follow: all cells that the ray enters later than the hit.
class KdTree final : public Accelerator {
 public:
  explicit KdTree(const TriangleSet& triangles, const KdSettings& settings = {});
  std::size_t memory() const override {
    return nodes_.size() * sizeof(KdNode) + ids_.size() * sizeof(ids_[0]);
  }
  std::span<const KdNode> nodes() const { return nodes_; }

 private:
  void traverse(Search& search) const override;

  std::vector<KdNode> nodes_;
  std::vector<std::uint32_t> ids_;  ///< of the leaves, one after the other
};

}  // namespace velum
