#include "kd_check.hpp"

#include <algorithm>
#include <cmath>

namespace velum {
namespace {

/// Indices have 30 bits.
constexpr std::size_t most_entries = std::size_t{1} << 30;

bool is_finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Reads the nodes in their order, as one who goes through the tree in preorder.
class PreorderCheck {
 public:
  explicit PreorderCheck(const KdArrays& tree) : tree_(tree), cell_(tree.cell) {}

  std::string run() {
    for (std::uint32_t i = 0; i < tree_.nodes.size(); ++i) {
      const KdNode& node = tree_.nodes[i];
      const std::string fault = node.is_leaf() ? leaf(node, i) : inner(node);
      if (!fault.empty()) return fault + " (node " + std::to_string(i) + ")";
    }
    if (!is_over_) return "the tree is not complete";
    return ids_seen_ == tree_.ids.size() ? "" : "there are more ids than the leaves hold";
  }

 private:
  /// A right child that is yet to come.
  struct Waiting {
    std::uint32_t node;
    Box cell;
  };

  std::string inner(const KdNode& node) {
    if (is_over_) return "the tree ends before the nodes do";
    if (waiting_.size() + 1 > KdArrays::most_depth) return "the tree is too deep";
    const int axis = node.axis();
    if (!(node.split > cell_.lower[axis] && node.split < cell_.upper[axis])) {
      return "a plane does not divide its cell";
    }
    Waiting right{node.index(), cell_};
    right.cell.lower[axis] = node.split;
    waiting_.push_back(right);
    cell_.upper[axis] = node.split;
    return {};
  }

  std::string leaf(const KdNode& node, std::uint32_t place) {
    if (is_over_) return "the tree ends before the nodes do";
    if (node.index() != ids_seen_) return "a leaf does not begin where the one before ends";
    if (node.count > tree_.ids.size() - ids_seen_) return "a leaf has more ids than there are";
    ids_seen_ += node.count;
    is_over_ = waiting_.empty();
    if (is_over_) return {};
    if (waiting_.back().node != place + 1) return "a right child does not follow what is left of it";
    cell_ = waiting_.back().cell;
    waiting_.pop_back();
    return {};
  }

  const KdArrays& tree_;
  Box cell_;  ///< of the node that comes next
  std::vector<Waiting> waiting_;
  std::size_t ids_seen_ = 0;
  bool is_over_ = false;
};

}  // namespace

std::string fault_in(const KdArrays& tree, std::uint32_t triangles) {
  if (tree.nodes.size() > most_entries || tree.ids.size() > most_entries) return "there are too many nodes";
  if (!(std::isfinite(tree.pad) && tree.pad >= 0.0)) return "the pad is no length";
  if (tree.nodes.empty()) return tree.ids.empty() ? "" : "there are ids but no nodes";
  if (tree.cell.is_empty() || !is_finite(tree.cell.lower) || !is_finite(tree.cell.upper)) {
    return "the root's cell is no box";
  }
  if (!tree.reaches.empty() && tree.reaches.size() != tree.nodes.size())
    return "the reaches are not one per node";
  const auto is_no_length = [](float v) { return !(std::isfinite(v) && v >= 0.0f); };
  if (std::any_of(tree.reaches.begin(), tree.reaches.end(), is_no_length)) return "a reach is no length";
  const auto is_outside = [triangles](std::uint32_t id) { return id >= triangles; };
  if (std::any_of(tree.ids.begin(), tree.ids.end(), is_outside)) return "an id is of no triangle";
  return PreorderCheck(tree).run();
}

}  // namespace velum
