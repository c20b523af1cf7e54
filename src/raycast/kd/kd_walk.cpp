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

void count_inner(Search& search) {
  ++search.counters.nodes;
  ++search.counters.boxes;
}

/// The walk as a function that calls itself.
struct Recursion {
  const KdArrays& tree;
  Search& search;
  KdWanted is_wanted{tree, search};
  Mailboxes mailboxes{};

  void visit(const Visit& visit_in) {
    // A hit ends nothing by itself: it may lie outside the cell it was found in, and beyond others. Only
    // cells that the ray enters after it are left out.
    if (visit_in.inside.is_empty() || !is_wanted(visit_in.node, visit_in.inside) || search.is_done()) return;
    const KdNode& node = tree.nodes[visit_in.node];
    if (node.is_leaf()) {
      test_leaf(tree, node, search, mailboxes);
      return;
    }
    count_inner(search);
    const Children children(tree, search.ray, visit_in);
    visit(children.near);
    visit(children.far);
  }
};

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
  Recursion recursion{tree, search};
  recursion.visit({0, recursion.is_wanted.root(bounds)});
}

void walk_by_stack(const KdArrays& tree, const Aabb& bounds, Search& search) {
  const KdWanted is_wanted(tree, search);
  Mailboxes mailboxes;
  std::array<Visit, KdArrays::most_depth + 1> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0, is_wanted.root(bounds)};
  while (waiting > 0 && !search.is_done()) {
    Visit visit = stack[--waiting];
    bool wanted = is_wanted(visit.node, visit.inside);
    while (wanted && !tree.nodes[visit.node].is_leaf()) {
      count_inner(search);
      const Children children(tree, search.ray, visit);
      if (children.near.inside.is_empty()) {
        visit = children.far;
      } else {
        if (!children.far.inside.is_empty()) stack[waiting++] = children.far;
        visit = children.near;
      }
      if (is_wanted.asks_every_node()) wanted = is_wanted(visit.node, visit.inside);
    }
    if (wanted) test_leaf(tree, tree.nodes[visit.node], search, mailboxes);
  }
}

}  // namespace velum
