// A hierarchy from the bottom up.
#include <algorithm>
#include <limits>

#include "bvh_build.hpp"

namespace velum {
namespace {

/// A subtree that has not been joined to another yet.
struct Cluster {
  Box box;
  std::int32_t left = -1, right = -1;  ///< clusters; -1: this is the item `item`
  std::uint32_t item = 0;
  std::uint32_t count = 1;
  double cost = 0.0;  ///< expected, times the box's area
};

/// Puts two zeros between the lowest 21 bits.
std::uint64_t spread(std::uint64_t v) {
  v = (v | v << 32) & 0x1F00000000FFFFull;
  v = (v | v << 16) & 0x1F0000FF0000FFull;
  v = (v | v << 8) & 0x100F00F00F00F00Full;
  v = (v | v << 4) & 0x10C30C30C30C30C3ull;
  return (v | v << 2) & 0x1249249249249249ull;
}

/// The place of a centre along the Z-curve (Morton 1966).
std::uint64_t place_on_curve(const BoxedItem& item, const Box& box) {
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = static_cast<double>(box.upper[axis]) - static_cast<double>(box.lower[axis]);
    const double centre = 0.5 * item.box.lower[axis] + 0.5 * item.box.upper[axis];
    const double share = size > 0.0 ? (centre - static_cast<double>(box.lower[axis])) / size : 0.0;
    code |= spread(static_cast<std::uint64_t>(std::clamp(share, 0.0, 1.0) * 0x1FFFFF)) << axis;
  }
  return code;
}

/// Joins clusters round by round: those that are each other's best neighbour.
class Clustering {
 public:
  Clustering(const std::vector<BoxedItem>& items, const BvhSettings& settings) : settings_(settings) {
    for (const BoxedItem& item : items) {
      active_.push_back(static_cast<std::int32_t>(clusters_.size()));
      clusters_.push_back({item.box, -1, -1, item.id, 1, item.box.half_area() * settings.triangle_cost});
    }
    while (active_.size() > 1) join_round();
  }

  BvhTree tree() {
    BvhTree tree;
    tree.nodes.emplace_back();
    emit(active_[0], 0, 0, tree);
    return tree;
  }

 private:
  static constexpr int radius = 12;  ///< neighbours looked at to each side

  const Cluster& at(std::int32_t index) const { return clusters_[static_cast<std::size_t>(index)]; }

  /// The place in active_ of the best partner; of equal ones the first.
  std::size_t best_partner(std::size_t place) const {
    const std::size_t begin = place < radius ? 0 : place - radius;
    const std::size_t end = std::min(active_.size(), place + radius + 1);
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = place == begin ? place + 1 : begin;
    for (std::size_t i = begin; i < end; ++i) {
      if (i == place) continue;
      Box box = at(active_[place]).box;
      box.include(at(active_[i]).box);
      const double area = box.half_area();
      if (area < least) {
        least = area;
        best = i;
      }
    }
    return best;
  }

  void join_round() {
    std::vector<std::size_t> partner(active_.size());
    for (std::size_t i = 0; i < active_.size(); ++i) partner[i] = best_partner(i);
    std::vector<std::int32_t> next;
    bool joined = false;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const bool mutual = partner[partner[i]] == i;
      if (mutual && partner[i] < i) continue;
      if (mutual) next.push_back(join(active_[i], active_[partner[i]]));
      if (!mutual) next.push_back(active_[i]);
      joined = joined || mutual;
    }
    if (!joined) {  // equal areas in a ring: the first two
      next[0] = join(next[0], next[1]);
      next.erase(next.begin() + 1);
    }
    active_ = std::move(next);
  }

  std::int32_t join(std::int32_t left, std::int32_t right) {
    Cluster cluster;
    cluster.box = at(left).box;
    cluster.box.include(at(right).box);
    cluster.left = left;
    cluster.right = right;
    cluster.count = at(left).count + at(right).count;
    const double area = cluster.box.half_area();
    const double divided = area * settings_.box_cost + at(left).cost + at(right).cost;
    cluster.cost = std::min(divided, area * cluster.count * settings_.triangle_cost);
    clusters_.push_back(cluster);
    return static_cast<std::int32_t>(clusters_.size() - 1);
  }

  /// Whether a subtree is cheaper as a leaf, T_SAH > T_P, or too deep to be divided.
  bool is_leaf(const Cluster& cluster, int depth) const {
    if (cluster.left < 0 || depth + 2 >= BvhTree::most_depth) return true;
    const double area = cluster.box.half_area();
    return area * settings_.box_cost + at(cluster.left).cost + at(cluster.right).cost >
           area * cluster.count * settings_.triangle_cost;
  }

  void emit_items(const Cluster& root, BvhTree& tree) const {
    std::vector<const Cluster*> waiting{&root};
    while (!waiting.empty()) {
      const Cluster& cluster = *waiting.back();
      waiting.pop_back();
      if (cluster.left < 0) tree.order.push_back(cluster.item);
      if (cluster.left >= 0) waiting.insert(waiting.end(), {&at(cluster.right), &at(cluster.left)});
    }
  }

  void emit(std::int32_t index, std::size_t node, int depth, BvhTree& tree) const {
    const Cluster& cluster = at(index);
    tree.nodes[node].lower = cluster.box.lower;
    tree.nodes[node].upper = cluster.box.upper;
    if (is_leaf(cluster, depth)) {
      tree.nodes[node].first = static_cast<std::uint32_t>(tree.order.size());
      tree.nodes[node].count = cluster.count;
      emit_items(cluster, tree);
      return;
    }
    const std::size_t children = tree.nodes.size();
    tree.nodes[node].first = static_cast<std::uint32_t>(children);
    tree.nodes.resize(children + 2);
    emit(cluster.left, children, depth + 1, tree);
    emit(cluster.right, children + 1, depth + 1, tree);
  }

  const BvhSettings& settings_;
  std::vector<Cluster> clusters_;
  std::vector<std::int32_t> active_;
};

}  // namespace

BvhTree build_agglomerative(std::vector<BoxedItem> items, const BvhSettings& settings) {
  if (items.empty()) return {};
  const Box box = box_around(items);
  std::sort(items.begin(), items.end(), [&box](const BoxedItem& a, const BoxedItem& b) {
    const std::uint64_t at_a = place_on_curve(a, box), at_b = place_on_curve(b, box);
    return at_a < at_b || (at_a == at_b && a.id < b.id);
  });
  return Clustering(items, settings).tree();
}

}  // namespace velum
