#include "bvh_build.hpp"

#include <algorithm>

namespace velum {
namespace {

/// Below this depth only medians divide, which end after 32 more steps: bounds every path.
constexpr int steps_of_rule = 48;

BvhRule rule_of(BvhSplit split) {
  switch (split) {
    case BvhSplit::median:
      return split_at_median;
    case BvhSplit::cyclic_median:
      return split_at_cyclic_median;
    case BvhSplit::midpoint:
      return split_at_midpoint;
    case BvhSplit::sah_sweep:
      return split_by_sweep;
    case BvhSplit::sah_binned:
    case BvhSplit::agglomerative:
      break;
  }
  return split_by_bins;
}

/// Builds from the top, depth first.
class TopDown {
 public:
  TopDown(std::vector<BoxedItem>& items, const BvhSettings& settings)
      : items_(items), settings_(settings), rule_(rule_of(settings.split)) {}

  BvhTree run() {
    tree_.nodes.reserve(items_.size());
    tree_.nodes.emplace_back();
    divide(0, 0, items_.size(), 0);
    tree_.order.reserve(items_.size());
    for (const BoxedItem& item : items_) tree_.order.push_back(item.id);
    tree_.nodes.shrink_to_fit();
    return std::move(tree_);
  }

 private:
  void divide(std::size_t node, std::size_t first, std::size_t last, int depth) {
    const std::span<BoxedItem> items(items_.data() + first, last - first);
    const Box box = box_around(items);
    tree_.nodes[node].lower = box.lower;
    tree_.nodes[node].upper = box.upper;
    const BvhRule rule = depth < steps_of_rule ? rule_ : split_at_cyclic_median;
    const std::size_t left = items.size() < 2 ? 0 : rule({items, box, depth}, settings_);
    if (left == 0) {
      tree_.nodes[node].first = static_cast<std::uint32_t>(first);
      tree_.nodes[node].count = static_cast<std::uint32_t>(items.size());
      return;
    }
    const std::size_t children = tree_.nodes.size();
    tree_.nodes[node].first = static_cast<std::uint32_t>(children);
    tree_.nodes.resize(children + 2);
    divide(children, first, first + left, depth + 1);
    divide(children + 1, first + left, last, depth + 1);
  }

  std::vector<BoxedItem>& items_;
  const BvhSettings& settings_;
  BvhRule rule_;
  BvhTree tree_;
};

}  // namespace

BvhTree build_bvh(std::vector<BoxedItem> items, const BvhSettings& settings) {
  if (items.empty()) return {};
  std::sort(items.begin(), items.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  if (settings.split == BvhSplit::agglomerative) return build_agglomerative(std::move(items), settings);
  return TopDown(items, settings).run();
}

double expected_cost(const BvhTree& tree, const BvhSettings& settings) {
  if (tree.nodes.empty()) return 0.0;
  const auto area = [](const BvhNode& node) { return Box{node.lower, node.upper}.half_area(); };
  const double root = area(tree.nodes[0]);
  double cost = 0.0;
  for (const BvhNode& node : tree.nodes) {
    const double share = root > 0.0 ? area(node) / root : 1.0;
    cost += share * (node.is_leaf() ? node.count * settings.triangle_cost : settings.box_cost);
  }
  return cost;
}

}  // namespace velum
