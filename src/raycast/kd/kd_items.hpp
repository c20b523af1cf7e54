#pragma once

#include <vector>

#include "kd_split.hpp"

namespace velum {

/// The boxes that a kd-tree's builder sorts, by index: those of the triangles, and behind them, for a while,
/// those of the parts that dividing planes cut them into.
class KdItems {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  /// The items that take an item's place on either side of a plane; none where nothing of it is there.
  struct Parts {
    std::uint32_t left = none, right = none;

    std::uint32_t on(KdSide side) const { return side == KdSide::left ? left : right; }
  };

  /// @param cell  around all of them
  KdItems(const TriangleSet& triangles, std::vector<BoxedItem> items, const Box& cell, double pad, KdCut cut);

  std::size_t size() const { return items_.size(); }
  const std::vector<BoxedItem>& all() const { return items_; }
  const Box& box(std::uint32_t item) const { return items_[item].box; }
  std::uint32_t id(std::uint32_t item) const { return items_[item].id; }

  /// An item in a cell that a plane divides: the item itself where it is whole. May add items.
  Parts divide(std::uint32_t item, const Box& cell, const KdPlane& plane);
  /// Removes all parts from an index on, when the cells they are in are done.
  void forget_from(std::size_t first);
  /// How far a hit can be from the cells that have the item: see KdArrays::reaches. 0 for whole triangles.
  float reach(std::uint32_t item) const;

 private:
  std::uint32_t part(std::uint32_t item, const Box& cell);

  const TriangleSet& triangles_;
  std::vector<BoxedItem> items_;
  std::size_t whole_;  ///< so many items are whole triangles
  double pad_;         ///< more than cutting a triangle rounds by
  KdCut cut_;
};

}  // namespace velum
