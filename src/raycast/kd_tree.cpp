#include "kd_tree.hpp"

#include <algorithm>
#include <array>

#include "kd_build.hpp"

namespace velum {

KdTree::KdTree(const TriangleSet& triangles, const KdSettings& settings) : Accelerator(triangles) {
  const std::vector<BoxedItem> items = boxed_triangles();
  if (items.empty()) return;
  KdArrays arrays = build_kd_tree(items, settings);
  nodes_ = std::move(arrays.nodes);
  ids_ = std::move(arrays.ids);
}

namespace {

/// A node and the part of the ray inside its cell.
struct Visit {
  std::uint32_t node;
  Interval inside;
};

/// Where the ray crosses a plane: it is on the near side until `leaves` and on the far side from `enters` on.
/// With the ray's margin the two parts overlap.
struct Crossing {
  double enters, leaves;
  bool lower_first;

  Crossing(const PreparedRay& ray, int axis, float split) {
    const double one = (static_cast<double>(split) - ray.ahead[axis]) * ray.inverse[axis];
    const double other = (static_cast<double>(split) - ray.behind[axis]) * ray.inverse[axis];
    enters = std::min(one, other);
    leaves = std::max(one, other);
    lower_first = ray.inverse[axis] > 0.0;
  }
};

}  // namespace

void KdTree::traverse(Search& search) const {
  const PreparedRay& ray = search.ray;
  Mailboxes mailboxes;
  std::array<Visit, 64> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {0, intersect(ray.through(bounds().lower, bounds().upper), ray.range)};
  while (waiting > 0) {
    Visit visit = stack[--waiting];
    if (visit.inside.lower > search.limit()) continue;
    while (!nodes_[visit.node].is_leaf()) {
      const KdNode& node = nodes_[visit.node];
      ++search.counters.nodes;
      ++search.counters.boxes;
      const Crossing crossing(ray, node.axis(), node.split);
      const std::uint32_t near = crossing.lower_first ? visit.node + 1 : node.index();
      const std::uint32_t far = crossing.lower_first ? node.index() : visit.node + 1;
      const Interval near_part = intersect(visit.inside, {-Interval{}.upper, crossing.leaves});
      const Interval far_part = intersect(visit.inside, {crossing.enters, Interval{}.upper});
      if (!near_part.is_empty()) {
        if (!far_part.is_empty()) stack[waiting++] = {far, far_part};
        visit = {near, near_part};
      } else {
        visit = {far, far_part};
      }
    }
    const KdNode& leaf = nodes_[visit.node];
    ++search.counters.nodes;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const std::uint32_t id = ids_[leaf.index() + i];
      if (!mailboxes.is_first_visit(id)) {
        ++search.counters.mailbox;
        continue;
      }
      search.test(id);
      if (search.is_done()) return;
    }
  }
}

}  // namespace velum
