#pragma once

#include "../accelerator.hpp"
#include "kd_ropes.hpp"

namespace velum {

/// How a ray finds its way through a kd-tree. All find the same hits.
enum class KdWalk {
  stack,      ///< a loop; the far children wait on a stack
  recursive,  ///< the same as a function that calls itself, to be read beside it
  ropes,      ///< from cell to neighbouring cell, without a stack: see KdRopes
};

/// What becomes of a triangle that a dividing plane cuts.
enum class KdCut {
  referenced,  ///< both sides have it, and go on as if it filled its box there
  split,  ///< each side has the box of its part, none where it has no part ("perfect splits": Wald & Havran
          ///< 2006). The triangle itself stays whole, so hits are the same.
};

struct KdSettings {
  double step_cost = 1.0;      ///< of going on to a child
  double triangle_cost = 1.5;  ///< of one intersection
  double empty_bonus = 0.2;    ///< by this share a split is cheaper that cuts empty space off
  int most_depth = 0;          ///< 0: 8 + 1.3·log2(n)
  KdWalk walk = KdWalk::stack;
  KdCut cut = KdCut::referenced;
  /// Per axis and cell, places where the cost of a plane is asked; cells with fewer triangles are divided
  /// exactly. 0: all are.
  int samples = 0;
  /// The leaves refer to each triangle so many times at most, on average. Without a bound large triangles
  /// that lie across each other are divided on and on, each time for a little gain.
  double most_references = 24.0;
};

/// A kd-tree: space is divided by planes across an axis; triangles that a plane cuts are referenced on both
/// sides. A triangle that is met in one cell can be hit in another one farther on, so a hit ends the search
/// only where nothing nearer can follow: all cells that the ray enters later than the hit.
class KdTree final : public Accelerator {
 public:
  explicit KdTree(const TriangleSet& triangles, const KdSettings& settings = {});
  /// A tree made before, over the same triangles. Ropes need a tree that was built for them (pad > 0);
  /// through others rays go by the stack. @pre fault_in(arrays, …) finds none, see kd_check.hpp
  KdTree(const TriangleSet& triangles, KdArrays arrays, KdWalk walk);

  std::size_t memory() const override { return arrays_.memory() + ropes_.memory(); }
  std::span<const KdNode> nodes() const { return arrays_.nodes; }
  const KdArrays& arrays() const { return arrays_; }
  const KdRopes& ropes() const { return ropes_; }

 private:
  void traverse(Search& search) const override;

  KdArrays arrays_;
  KdWalk walk_;
  KdRopes ropes_;
};

}  // namespace velum
