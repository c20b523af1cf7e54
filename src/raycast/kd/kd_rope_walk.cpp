// A ray through a kd-tree along ropes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "kd_walk.hpp"

namespace velum {
namespace {

/// Where the ray is on its way from cell to cell.
///
/// The place never goes back, on any axis, and never leaves the cell it is in: it is set to the very plane
/// that is crossed, and on the other axes put between where it was and the cell's far side. So a walk ends:
/// every step crosses a plane for good. Rounding can make the place differ from the ray's by less than the
/// margin, which is what the tree's pad is for.
struct RopeWalk {
  const KdArrays& tree;
  const KdRopes& ropes;
  const PreparedRay& ray;
  CastCounters& counters;
  glm::dvec3 place{0.0};
  double t = 0.0;
  const RopedLeaf* leaf = nullptr;
  std::uint32_t leaf_node = 0;

  bool ascends(int axis) const { return ray.inverse[axis] > 0.0; }
  std::uint32_t rope(int axis) const {
    return leaf->ropes[2 * static_cast<std::size_t>(axis) + (ascends(axis) ? 1 : 0)];
  }
  double far_side(int axis) const {
    return static_cast<double>(ascends(axis) ? leaf->cell.upper[axis] : leaf->cell.lower[axis]);
  }

  void start(double entry) {
    t = entry;
    place = glm::clamp(ray.ray.at(t), glm::dvec3(tree.cell.lower), glm::dvec3(tree.cell.upper));
    descend(0);
  }

  /// To the leaf below a node that holds the place; what is exactly in a plane counts as having crossed it.
  void descend(std::uint32_t node) {
    while (!tree.nodes[node].is_leaf()) {
      const KdNode& inner = tree.nodes[node];
      ++counters.nodes;
      const double split = static_cast<double>(inner.split);
      const bool is_above =
          ascends(inner.axis()) ? place[inner.axis()] >= split : place[inner.axis()] > split;
      node = is_above ? inner.index() : node + 1;
    }
    leaf_node = node;
    leaf = &ropes.leaves[ropes.leaf_of_node[node]];
  }

  /// Through the side that the ray meets first. @return whether there is one that leads on
  bool step() {
    int axis = -1;
    double leaves = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      if (rope(i) == RopedLeaf::outside) continue;  // through the scene's own sides nothing is crossed
      const double crossing = (far_side(i) - ray.ray.origin[i]) * ray.inverse[i];
      if (crossing < leaves) {
        leaves = crossing;
        axis = i;
      }
    }
    ++counters.boxes;
    if (axis < 0) return false;
    t = std::max(t, leaves);
    move_to(axis);
    descend(rope(axis));
    return true;
  }

  void move_to(int axis) {
    for (int i = 0; i < 3; ++i) {
      const double far = far_side(i);
      const double reached = i == axis ? far : ray.ray.at(t)[i];
      place[i] = ascends(i) ? std::min(std::max(place[i], reached), far)
                            : std::max(std::min(place[i], reached), far);
    }
  }
};

}  // namespace

bool walk_by_ropes(const KdArrays& tree, const KdRopes& ropes, const Aabb& bounds, Search& search) {
  const PreparedRay& ray = search.ray;
  const KdWanted is_wanted(tree, search);
  const Interval inside = is_wanted.root(bounds);
  if (ropes.is_empty() || ray.margin * 16.0 > tree.pad || !std::isfinite(inside.lower)) return false;
  Mailboxes mailboxes;
  RopeWalk walk{tree, ropes, ray, search.counters};
  for (walk.start(inside.lower); walk.t <= inside.upper && is_wanted(0, {walk.t, inside.upper});) {
    test_leaf(tree, tree.nodes[walk.leaf_node], search, mailboxes);
    if (search.is_done() || !walk.step()) break;
  }
  return true;
}

}  // namespace velum
