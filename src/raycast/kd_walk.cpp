#include "kd_walk.hpp"

#include <algorithm>
#include <array>

namespace velum {
namespace {

/// A node and the part of the ray inside its cell.
struct Visit {
  std::uint32_t node;
  Interval inside;
};

/// An inner node's children in the order in which the ray meets them, each with its part of the ray: near up
/// to the plane, far from there on. With the ray's margin the parts overlap.
struct Children {
  Visit near, far;

  Children(const KdArrays& tree, const PreparedRay& ray, const Visit& visit) {
    const KdNode& node = tree.nodes[visit.node];
    const int axis = node.axis();
    const double one = (static_cast<double>(node.split) - ray.ahead[axis]) * ray.inverse[axis];
    const double other = (static_cast<double>(node.split) - ray.behind[axis]) * ray.inverse[axis];
    const double enters = std::min(one, other), leaves = std::max(one, other);
    const bool lower_first = ray.inverse[axis] > 0.0;
    near = {lower_first ? visit.node + 1 : node.index(),
            intersect(visit.inside, {-Interval{}.upper, leaves})};
    far = {lower_first ? node.index() : visit.node + 1, intersect(visit.inside, {enters, Interval{}.upper})};
  }
};

Visit root_visit(const Aabb& bounds, const PreparedRay& ray) {
  return {0, intersect(ray.through(bounds.lower, bounds.upper), ray.range)};
}

void count_inner(Search& search) {
  ++search.counters.nodes;
  ++search.counters.boxes;
}

void recurse(const KdArrays& tree, const Visit& visit, Search& search, Mailboxes& mailboxes) {
  // A hit ends nothing by itself: it may lie outside the cell it was found in, and beyond others. Only cells
  // that the ray enters after it are left out.
  if (visit.inside.is_empty() || visit.inside.lower > search.limit() || search.is_done()) return;
  const KdNode& node = tree.nodes[visit.node];
  if (node.is_leaf()) {
    test_leaf(tree, node, search, mailboxes);
    return;
  }
  count_inner(search);
  const Children children(tree, search.ray, visit);
  recurse(tree, children.near, search, mailboxes);
  recurse(tree, children.far, search, mailboxes);
}

}  // namespace

void test_leaf(const KdArrays& tree, const KdNode& leaf, Search& search, Mailboxes& mailboxes) {
  ++search.counters.nodes;
  for (std::uint32_t i = 0; i < leaf.count && !search.is_done(); ++i) {
    const std::uint32_t id = tree.ids[leaf.index() + i];
    if (mailboxes.is_first_visit(id)) {
      search.test(id);
    } else {
      ++search.counters.mailbox;
    }
  }
}

void walk_by_recursion(const KdArrays& tree, const Aabb& bounds, Search& search) {
  Mailboxes mailboxes;
  recurse(tree, root_visit(bounds, search.ray), search, mailboxes);
}

void walk_by_stack(const KdArrays& tree, const Aabb& bounds, Search& search) {
  const PreparedRay& ray = search.ray;
  Mailboxes mailboxes;
  std::array<Visit, KdArrays::most_depth + 1> stack;
  std::size_t waiting = 0;
  stack[waiting++] = root_visit(bounds, ray);
  while (waiting > 0) {
    Visit visit = stack[--waiting];
    if (visit.inside.lower > search.limit()) continue;
    while (!tree.nodes[visit.node].is_leaf()) {
      count_inner(search);
      const Children children(tree, ray, visit);
      if (children.near.inside.is_empty()) {
        visit = children.far;
      } else {
        if (!children.far.inside.is_empty()) stack[waiting++] = children.far;
        visit = children.near;
      }
    }
    test_leaf(tree, tree.nodes[visit.node], search, mailboxes);
    if (search.is_done()) return;
  }
}

}  // namespace velum
