#include "kd_items.hpp"

#include <algorithm>

namespace velum {

KdItems::KdItems(const TriangleSet& triangles, std::vector<BoxedItem> items, const Box& cell, double pad,
                 KdCut cut)
    : triangles_(triangles), items_(std::move(items)), whole_(items_.size()), cut_(cut) {
  const glm::vec3 reach = glm::max(glm::abs(cell.lower), glm::abs(cell.upper));
  pad_ = std::max(pad, 0x1.0p-40 * static_cast<double>(std::max({reach.x, reach.y, reach.z})));
}

KdItems::Parts KdItems::divide(std::uint32_t item, const Box& cell, const KdPlane& plane) {
  const KdSide side = side_of(items_[item].box, plane);
  if (side == KdSide::left) return {item, none};
  if (side == KdSide::right) return {none, item};
  if (cut_ == KdCut::referenced) return {item, item};
  const std::uint32_t left = part(item, half_of(cell, plane, KdSide::left));
  return {left, part(item, half_of(cell, plane, KdSide::right))};
}

std::uint32_t KdItems::part(std::uint32_t item, const Box& cell) {
  const std::optional<Box> box = box_of_part(triangles_[items_[item].id], cell, pad_);
  if (!box) return none;
  BoxedItem result = items_[item];
  result.box.lower = glm::max(result.box.lower, box->lower);
  result.box.upper = glm::min(result.box.upper, box->upper);
  if (result.box.is_empty()) return none;
  items_.push_back(result);
  return static_cast<std::uint32_t>(items_.size() - 1);
}

void KdItems::forget_from(std::size_t first) {
  items_.resize(first);
}

float KdItems::reach(std::uint32_t item) const {
  if (item < whole_) return 0.0f;
  const Triangle t = triangles_[items_[item].id];
  const glm::dvec3 size = glm::max(glm::max(t.a, t.b), t.c) - glm::min(glm::min(t.a, t.b), t.c);
  return float_above(std::max({size.x, size.y, size.z}));
}

}  // namespace velum
