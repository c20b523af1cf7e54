#include "kd_sorted_cell.hpp"

#include <algorithm>

namespace velum {

SortedKdCell::SortedKdCell(const KdItems& items, const Box& box, std::span<const std::uint32_t> inside)
    : box_(box), count_(inside.size()) {
  for (int axis = 0; axis < 3; ++axis) {
    Edges& edges = edges_[static_cast<std::size_t>(axis)];
    edges.reserve(2 * inside.size());
    for (const std::uint32_t item : inside) add_edges(items, item, axis, edges);
    std::sort(edges.begin(), edges.end());
  }
}

void SortedKdCell::add_edges(const KdItems& items, std::uint32_t item, int axis, Edges& edges) {
  const Box& box = items.box(item);
  if (box.lower[axis] == box.upper[axis]) {
    edges.push_back({box.lower[axis], Edge::flat, item});
  } else {
    edges.push_back({box.lower[axis], Edge::begin, item});
    edges.push_back({box.upper[axis], Edge::end, item});
  }
}

std::vector<std::uint32_t> SortedKdCell::inside() const {
  std::vector<std::uint32_t> result;
  result.reserve(count_);
  for (const Edge& edge : edges_[0]) {
    if (edge.kind != Edge::end) result.push_back(edge.item);
  }
  return result;
}

KdPlane SortedKdCell::best_plane(const KdSettings& settings) const {
  KdPlane best;
  for (int axis = 0; axis < 3; ++axis) sweep(axis, settings, best);
  return best;
}

/// Sweeps a plane along an axis: what ends before it no longer counts on the right, what begins before it
/// counts on the left. Flat items in the plane count on the left.
void SortedKdCell::sweep(int axis, const KdSettings& settings, KdPlane& best) const {
  const Edges& edges = edges_[static_cast<std::size_t>(axis)];
  const KdCost cost(settings, box_, axis);
  std::size_t left = 0, right = count_;
  for (std::size_t i = 0; i < edges.size();) {
    const float place = edges[i].place;
    std::size_t counts[3] = {};
    for (; i < edges.size() && edges[i].place == place; ++i) ++counts[edges[i].kind];
    left += counts[Edge::flat];
    right -= counts[Edge::end] + counts[Edge::flat];
    if (place > box_.lower[axis] && place < box_.upper[axis]) {
      const double c =
          cost(static_cast<double>(place), static_cast<double>(left), static_cast<double>(right));
      if (c < best.cost) best = {c, axis, place};
    }
    left += counts[Edge::begin];
  }
}

SortedKdCell SortedKdCell::half(const KdItems& items, std::span<const KdItems::Parts> parts,
                                const KdPlane& plane, KdSide side) const {
  SortedKdCell result(half_of(box_, plane, side));
  for (const Edge& edge : edges_[0]) {
    result.count_ += edge.kind != Edge::end && parts[edge.item].on(side) != KdItems::none;
  }
  const std::size_t axes = result.count_ > 1 ? 3 : 1;  // one item is not divided: only its name is asked for
  for (std::size_t axis = 0; axis < axes; ++axis) {
    Edges kept, fresh;
    kept.reserve(edges_[axis].size());
    for (const Edge& edge : edges_[axis]) {
      const std::uint32_t part = parts[edge.item].on(side);
      if (part == edge.item) {
        kept.push_back(edge);
      } else if (part != KdItems::none && edge.kind != Edge::end) {
        add_edges(items, part, static_cast<int>(axis), fresh);
      }
    }
    Edges& edges = result.edges_[axis];
    if (fresh.empty()) {
      edges = std::move(kept);
      continue;
    }
    std::sort(fresh.begin(), fresh.end());
    edges.resize(kept.size() + fresh.size());
    std::merge(kept.begin(), kept.end(), fresh.begin(), fresh.end(), edges.begin());
  }
  return result;
}

}  // namespace velum
