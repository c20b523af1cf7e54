#include "kd_tree.hpp"

#include <algorithm>

#include "kd_build.hpp"
#include "kd_split.hpp"
#include "kd_walk.hpp"

namespace velum {
namespace {

void pad_boxes(std::vector<BoxedItem>& items, double pad) {
  for (BoxedItem& item : items) {
    for (int axis = 0; axis < 3; ++axis) {
      item.box.lower[axis] = float_below(static_cast<double>(item.box.lower[axis]) - pad);
      item.box.upper[axis] = float_above(static_cast<double>(item.box.upper[axis]) + pad);
    }
  }
}

}  // namespace

KdTree::KdTree(const TriangleSet& triangles, const KdSettings& settings)
    : Accelerator(triangles), walk_(settings.walk) {
  std::vector<BoxedItem> items = boxed_triangles();
  if (items.empty()) return;
  double pad = 0.0;
  if (walk_ == KdWalk::ropes) {
    const glm::dvec3 size = bounds().size();
    pad = 0x1.0p-24 * std::max({size.x, size.y, size.z});
    pad_boxes(items, pad);
  }
  arrays_ = build_kd_tree(triangles, std::move(items), pad, settings);
  if (walk_ == KdWalk::ropes) ropes_ = rope_kd_tree(arrays_);
}

KdTree::KdTree(const TriangleSet& triangles, KdArrays arrays, KdWalk walk)
    : Accelerator(triangles), arrays_(std::move(arrays)), walk_(walk) {
  if (walk_ == KdWalk::ropes && arrays_.pad > 0.0) ropes_ = rope_kd_tree(arrays_);
}

void KdTree::traverse(Search& search) const {
  if (arrays_.nodes.empty()) return;
  if (walk_ == KdWalk::ropes && walk_by_ropes(arrays_, ropes_, bounds(), search)) return;
  if (walk_ == KdWalk::recursive) {
    walk_by_recursion(arrays_, bounds(), search);
  } else {
    walk_by_stack(arrays_, bounds(), search);
  }
}

}  // namespace velum
