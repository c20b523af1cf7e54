#include "kd_build.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "kd_sorted_cell.hpp"

namespace velum {
namespace {

using Indices = std::vector<std::uint32_t>;  ///< of items, not ids

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

class KdBuilder {
 public:
  KdBuilder(const TriangleSet& triangles, std::vector<BoxedItem> items, double pad,
            const KdSettings& settings)
      : settings_(settings),
        arrays_(empty_tree(items, pad)),
        items_(triangles, std::move(items), arrays_.cell, pad, settings.cut) {}

  KdArrays run() {
    Indices all(items_.size());
    std::iota(all.begin(), all.end(), 0u);
    const double references = settings_.most_references * static_cast<double>(items_.size());
    divide(arrays_.cell, std::move(all), {kd_depth(settings_, items_.size()), references});
    if (settings_.cut == KdCut::split) widen_reaches();
    return std::move(arrays_);
  }

 private:
  static KdArrays empty_tree(const std::vector<BoxedItem>& items, double pad) {
    KdArrays tree;
    tree.cell = box_around(items);
    tree.pad = pad;
    return tree;
  }

  /// By samples: the cell is a list of items, in no order.
  void divide(const Box& cell, Indices inside, const Budget& budget) {
    if (settings_.samples <= 0 || inside.size() < static_cast<std::size_t>(settings_.samples)) {
      divide_exactly(SortedKdCell(items_, cell, inside), budget);
      return;
    }
    KdPlane plane;
    if (budget.depth > 0) plane = sampled_plane(items_.all(), inside, cell, settings_);
    const std::size_t node = begin_node();
    const std::size_t first_part = items_.size();
    Indices left, right;
    if (plane.pays(settings_, inside.size())) {
      for (const std::uint32_t item : inside) {
        const KdItems::Parts parts = items_.divide(item, cell, plane);
        if (parts.left != KdItems::none) left.push_back(parts.left);
        if (parts.right != KdItems::none) right.push_back(parts.right);
      }
    }
    if (plane.pays(settings_, inside.size()) && budget.allows(left.size(), right.size())) {
      inside = {};
      const Budget for_left = budget.share(left.size(), right.size());
      const Budget for_right = budget.share(right.size(), left.size());
      divide(half_of(cell, plane, KdSide::left), std::move(left), for_left);
      make_inner(node, plane);
      divide(half_of(cell, plane, KdSide::right), std::move(right), for_right);
    } else {
      make_leaf(node, inside);
    }
    items_.forget_from(first_part);
  }

  void divide_exactly(SortedKdCell cell, const Budget& budget) {
    KdPlane plane;
    if (budget.depth > 0 && cell.count() > 1) plane = cell.best_plane(settings_);
    const std::size_t node = begin_node();
    const Indices inside = cell.inside();
    if (!plane.pays(settings_, cell.count())) {
      make_leaf(node, inside);
      return;
    }
    const std::size_t first_part = items_.size();
    parts_of_.resize(std::max(parts_of_.size(), items_.size()));
    for (const std::uint32_t item : inside) parts_of_[item] = items_.divide(item, cell.box(), plane);
    SortedKdCell left = cell.half(items_, parts_of_, plane, KdSide::left);
    SortedKdCell right = cell.half(items_, parts_of_, plane, KdSide::right);
    if (budget.allows(left.count(), right.count())) {
      const Budget for_left = budget.share(left.count(), right.count());
      const Budget for_right = budget.share(right.count(), left.count());
      { const SortedKdCell done = std::move(cell); }  // its memory, before going down
      divide_exactly(std::move(left), for_left);
      make_inner(node, plane);
      divide_exactly(std::move(right), for_right);
    } else {
      make_leaf(node, inside);
    }
    items_.forget_from(first_part);
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

  void make_leaf(std::size_t node, const Indices& inside) {
    arrays_.nodes[node].word = static_cast<std::uint32_t>(arrays_.ids.size()) << 2 | 3u;
    arrays_.nodes[node].count = static_cast<std::uint32_t>(inside.size());
    for (const std::uint32_t item : inside) {
      arrays_.ids.push_back(items_.id(item));
      if (settings_.cut == KdCut::split) {
        arrays_.reaches[node] = std::max(arrays_.reaches[node], items_.reach(item));
      }
    }
  }

  /// From the leaves up: children come after their parents.
  void widen_reaches() {
    for (std::size_t i = arrays_.nodes.size(); i-- > 0;) {
      const KdNode& node = arrays_.nodes[i];
      if (node.is_leaf()) continue;
      arrays_.reaches[i] = std::max(arrays_.reaches[i + 1], arrays_.reaches[node.index()]);
    }
  }

  const KdSettings& settings_;
  KdArrays arrays_;
  KdItems items_;
  std::vector<KdItems::Parts> parts_of_;  ///< of each item, while a cell is divided
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
