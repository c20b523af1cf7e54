#pragma once

#include <array>
#include <span>
#include <vector>

#include "kd_items.hpp"

namespace velum {

/// A cell of a kd-tree being built, as the sorted sides of its items' boxes: what an exact sweep goes over.
class SortedKdCell {
 public:
  SortedKdCell(const KdItems& items, const Box& box, std::span<const std::uint32_t> inside);

  const Box& box() const { return box_; }
  std::size_t count() const { return count_; }
  /// Its items' indices.
  std::vector<std::uint32_t> inside() const;
  /// The plane of least cost of all at the sides of boxes.
  KdPlane best_plane(const KdSettings& settings) const;
  /// One side of a plane. Those that stay whole keep their order; the sides of parts, of which there are few,
  /// are sorted and merged into it.
  /// @param parts  of each item inside, by index
  SortedKdCell half(const KdItems& items, std::span<const KdItems::Parts> parts, const KdPlane& plane,
                    KdSide side) const;

 private:
  /// A side of a box across an axis. Sorted by place, then ends before flat ones before beginnings.
  struct Edge {
    enum Kind : std::uint8_t { end, flat, begin };
    float place;
    Kind kind;
    std::uint32_t item;

    bool operator<(const Edge& other) const {
      if (place != other.place) return place < other.place;
      return kind != other.kind ? kind < other.kind : item < other.item;
    }
  };
  using Edges = std::vector<Edge>;

  explicit SortedKdCell(const Box& box) : box_(box) {}
  static void add_edges(const KdItems& items, std::uint32_t item, int axis, Edges& edges);
  void sweep(int axis, const KdSettings& settings, KdPlane& best) const;

  Box box_;
  std::array<Edges, 3> edges_;
  std::size_t count_ = 0;
};

}  // namespace velum
