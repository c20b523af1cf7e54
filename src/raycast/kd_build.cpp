#include "kd_build.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "kd_split.hpp"

namespace velum {
namespace {

/// A side of a box across an axis. Sorted by place, then ends before flat ones before beginnings.
struct Edge {
  enum Kind : std::uint8_t { end, flat, begin };
  float place;
  Kind kind;
  std::uint32_t item;  ///< index, not id

  bool operator<(const Edge& other) const {
    if (place != other.place) return place < other.place;
    return kind != other.kind ? kind < other.kind : item < other.item;
  }
};
using Edges = std::vector<Edge>;

/// Items of a cell: the sides of their boxes along x, y and z, and how many they are.
struct SortedCell {
  Box box;
  std::array<Edges, 3> edges;
  std::size_t count = 0;
};

using Items = std::vector<std::uint32_t>;  ///< indices, not ids

class KdBuilder {
 public:
  KdBuilder(const TriangleSet& triangles, std::vector<BoxedItem> items, double pad,
            const KdSettings& settings)
      : triangles_(triangles), settings_(settings), items_(std::move(items)) {
    arrays_.cell = box_around(items_);
    arrays_.pad = pad;
    const glm::vec3 reach = glm::max(glm::abs(arrays_.cell.lower), glm::abs(arrays_.cell.upper));
    cut_pad_ = std::max(pad, 0x1.0p-40 * static_cast<double>(std::max({reach.x, reach.y, reach.z})));
  }

  KdArrays run() {
    Items all(items_.size());
    std::iota(all.begin(), all.end(), 0u);
    is_part_.resize(items_.size(), false);
    const double budget = settings_.most_references * static_cast<double>(items_.size());
    divide(arrays_.cell, std::move(all), {kd_depth(settings_, items_.size()), budget});
    if (settings_.cut == KdCut::split) widen_reaches();
    return std::move(arrays_);
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  /// What a cell may still spend: levels below it, and references in its leaves.
  struct Budget {
    int depth;
    double references;

    bool allows(std::size_t left, std::size_t right) const {
      return static_cast<double>(left + right) <= references;
    }
    /// A child's, in proportion to its items.
    Budget share(std::size_t of, std::size_t other) const {
      return {depth - 1, references * static_cast<double>(of) / static_cast<double>(of + other)};
    }
  };

  /// The items that take the place of one which a plane cuts; none where nothing of it is on that side.
  struct Parts {
    std::uint32_t left = none, right = none;

    std::uint32_t on(KdSide side) const { return side == KdSide::left ? left : right; }
  };

  // ---- By samples: a cell is a list of items, in no order. ----

  void divide(const Box& cell, Items inside, const Budget& budget) {
    if (inside.size() < static_cast<std::size_t>(std::max(settings_.samples, 0)) || settings_.samples <= 0) {
      divide_exactly(sorted(cell, inside), budget);
      return;
    }
    KdPlane plane;
    if (budget.depth > 0) plane = sampled_plane(items_, inside, cell, settings_);
    const std::size_t node = begin_node();
    if (!plane.pays(settings_, inside.size())) {
      make_leaf(node, inside);
      return;
    }
    const std::size_t first_part = items_.size();
    Items left, right;
    for (const std::uint32_t item : inside) {
      const KdSide side = side_of(items_[item].box, plane);
      const Parts parts = side == KdSide::both ? cut(item, cell, plane) : Parts{item, item};
      if (is_on(side, KdSide::left) && parts.left != none) left.push_back(parts.left);
      if (is_on(side, KdSide::right) && parts.right != none) right.push_back(parts.right);
    }
    if (!budget.allows(left.size(), right.size())) {
      make_leaf(node, inside);
    } else {
      inside = {};
      const Budget for_left = budget.share(left.size(), right.size());
      const Budget for_right = budget.share(right.size(), left.size());
      divide(half_of(cell, plane, KdSide::left), std::move(left), for_left);
      make_inner(node, plane);
      divide(half_of(cell, plane, KdSide::right), std::move(right), for_right);
    }
    forget_parts(first_part);
  }

  // ---- Exactly: a cell is the sorted sides of its items. ----

  void divide_exactly(SortedCell cell, const Budget& budget) {
    KdPlane plane;
    if (budget.depth > 0 && cell.count > 1) {
      for (int axis = 0; axis < 3; ++axis) sweep(cell, axis, plane);
    }
    const std::size_t node = begin_node();
    if (!plane.pays(settings_, cell.count)) {
      make_leaf(node, items_of(cell));
      return;
    }
    const std::size_t first_part = items_.size();
    const Items inside = items_of(cell);
    place_items(inside, cell.box, plane);
    SortedCell left = half(cell, inside, plane, KdSide::left);
    SortedCell right = half(cell, inside, plane, KdSide::right);
    if (!budget.allows(left.count, right.count)) {
      make_leaf(node, inside);
    } else {
      cell = {};
      const Budget for_left = budget.share(left.count, right.count);
      const Budget for_right = budget.share(right.count, left.count);
      divide_exactly(std::move(left), for_left);
      make_inner(node, plane);
      divide_exactly(std::move(right), for_right);
    }
    forget_parts(first_part);
  }

  void add_edges(std::uint32_t item, int axis, Edges& edges) const {
    const Box& box = items_[item].box;
    if (box.lower[axis] == box.upper[axis]) {
      edges.push_back({box.lower[axis], Edge::flat, item});
    } else {
      edges.push_back({box.lower[axis], Edge::begin, item});
      edges.push_back({box.upper[axis], Edge::end, item});
    }
  }

  SortedCell sorted(const Box& box, const Items& inside) const {
    SortedCell cell{box, {}, inside.size()};
    for (int axis = 0; axis < 3; ++axis) {
      Edges& edges = cell.edges[static_cast<std::size_t>(axis)];
      edges.reserve(2 * inside.size());
      for (const std::uint32_t item : inside) add_edges(item, axis, edges);
      std::sort(edges.begin(), edges.end());
    }
    return cell;
  }

  static Items items_of(const SortedCell& cell) {
    Items result;
    for (const Edge& edge : cell.edges[0]) {
      if (edge.kind != Edge::end) result.push_back(edge.item);
    }
    return result;
  }

  /// Sweeps a plane along an axis: what ends before it no longer counts on the right, what begins before it
  /// counts on the left. Flat items in the plane count on the left.
  void sweep(const SortedCell& cell, int axis, KdPlane& best) const {
    const Edges& edges = cell.edges[static_cast<std::size_t>(axis)];
    const KdCost cost(settings_, cell.box, axis);
    std::size_t left = 0, right = cell.count;
    for (std::size_t i = 0; i < edges.size();) {
      const float place = edges[i].place;
      std::size_t counts[3] = {};
      for (; i < edges.size() && edges[i].place == place; ++i) ++counts[edges[i].kind];
      left += counts[Edge::flat];
      right -= counts[Edge::end] + counts[Edge::flat];
      if (place > cell.box.lower[axis] && place < cell.box.upper[axis]) {
        const double c =
            cost(static_cast<double>(place), static_cast<double>(left), static_cast<double>(right));
        if (c < best.cost) best = {c, axis, place};
      }
      left += counts[Edge::begin];
    }
  }

  void place_items(const Items& inside, const Box& cell, const KdPlane& plane) {
    side_of_.resize(items_.size());
    parts_of_.resize(items_.size());
    for (const std::uint32_t item : inside) {
      const KdSide side = side_of(items_[item].box, plane);
      side_of_[item] = side;
      parts_of_[item] = side == KdSide::both ? cut(item, cell, plane) : Parts{item, item};
    }
  }

  /// The items of one side of the plane, in the order they have; the sides of parts, of which there are few,
  /// are sorted and merged into it.
  SortedCell half(const SortedCell& cell, const Items& inside, const KdPlane& plane, KdSide side) const {
    SortedCell result{half_of(cell.box, plane, side), {}, 0};
    for (const std::uint32_t item : inside) {
      result.count += is_on(side_of_[item], side) && parts_of_[item].on(side) != none;
    }
    const std::size_t axes = result.count > 1 ? 3 : 1;  // one item is not divided: only its name is asked for
    for (std::size_t axis = 0; axis < axes; ++axis) {
      Edges kept, fresh;
      kept.reserve(cell.edges[axis].size());
      for (const Edge& edge : cell.edges[axis]) {
        if (!is_on(side_of_[edge.item], side)) continue;
        const std::uint32_t part = parts_of_[edge.item].on(side);
        if (part == edge.item) kept.push_back(edge);
        if (part == edge.item || part == none || edge.kind == Edge::end) continue;
        add_edges(part, static_cast<int>(axis), fresh);
      }
      Edges& edges = result.edges[axis];
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

  // ---- Both. ----

  Parts cut(std::uint32_t item, const Box& cell, const KdPlane& plane) {
    if (settings_.cut == KdCut::referenced) return {item, item};
    return {part(item, half_of(cell, plane, KdSide::left)), part(item, half_of(cell, plane, KdSide::right))};
  }

  std::uint32_t part(std::uint32_t item, const Box& cell) {
    const std::optional<Box> box = box_of_part(triangles_[items_[item].id], cell, cut_pad_);
    if (!box) return none;
    BoxedItem result = items_[item];
    result.box.lower = glm::max(result.box.lower, box->lower);
    result.box.upper = glm::min(result.box.upper, box->upper);
    if (result.box.is_empty()) return none;
    items_.push_back(result);
    is_part_.push_back(true);
    return static_cast<std::uint32_t>(items_.size() - 1);
  }

  void forget_parts(std::size_t first) {
    items_.resize(first);
    is_part_.resize(first);
  }

  std::size_t begin_node() {
    arrays_.nodes.emplace_back();
    if (settings_.cut == KdCut::split) arrays_.reaches.push_back(0.0f);
    return arrays_.nodes.size() - 1;
  }

  /// @pre the left subtree is complete
  void make_inner(std::size_t node, const KdPlane& plane) {
    arrays_.nodes[node].split = plane.place;
    arrays_.nodes[node].word =
        static_cast<std::uint32_t>(arrays_.nodes.size()) << 2 | static_cast<std::uint32_t>(plane.axis);
  }

  void make_leaf(std::size_t node, const Items& inside) {
    arrays_.nodes[node].word = static_cast<std::uint32_t>(arrays_.ids.size()) << 2 | 3u;
    arrays_.nodes[node].count = static_cast<std::uint32_t>(inside.size());
    for (const std::uint32_t item : inside) {
      arrays_.ids.push_back(items_[item].id);
      if (is_part_[item]) arrays_.reaches[node] = std::max(arrays_.reaches[node], extent(items_[item].id));
    }
  }

  /// The longest side of a triangle's box.
  float extent(std::uint32_t triangle) const {
    const Triangle t = triangles_[triangle];
    const glm::dvec3 size = glm::max(glm::max(t.a, t.b), t.c) - glm::min(glm::min(t.a, t.b), t.c);
    return float_above(std::max({size.x, size.y, size.z}));
  }

  /// From the leaves up: children come after their parents.
  void widen_reaches() {
    for (std::size_t i = arrays_.nodes.size(); i-- > 0;) {
      const KdNode& node = arrays_.nodes[i];
      if (node.is_leaf()) continue;
      arrays_.reaches[i] = std::max(arrays_.reaches[i + 1], arrays_.reaches[node.index()]);
    }
  }

  const TriangleSet& triangles_;
  const KdSettings& settings_;
  std::vector<BoxedItem> items_;  ///< behind those of the triangles, parts of the cells being divided
  std::vector<bool> is_part_;
  double cut_pad_ = 0.0;         ///< more than cutting a triangle rounds by
  std::vector<KdSide> side_of_;  ///< of each item, while a cell is divided
  std::vector<Parts> parts_of_;
  KdArrays arrays_;
};

}  // namespace

int kd_depth(const KdSettings& settings, std::size_t n) {
  if (settings.most_depth > 0) return std::min(settings.most_depth, KdArrays::most_depth);
  return 8 + static_cast<int>(1.3 * static_cast<double>(std::bit_width(n)));
}

KdArrays build_kd_tree(const TriangleSet& triangles, std::vector<BoxedItem> items, double pad,
                       const KdSettings& settings) {
  return KdBuilder(triangles, std::move(items), pad, settings).run();
}

}  // namespace velum
