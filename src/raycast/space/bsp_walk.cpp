// A ray through a BSP tree, front to back.
#include <array>
#include <glm/geometric.hpp>

#include "bsp_tree.hpp"

namespace velum {
namespace {

/// A node and the part of the ray inside its cell.
struct Visit {
  std::uint32_t node;
  Interval inside;
};

}  // namespace

bool BspTree::test(const Node& node, Search& search, Mailboxes& mailboxes) const {
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    if (!mailboxes.is_first_visit(ids_[i])) {
      ++search.counters.mailbox;
      continue;
    }
    search.test(ids_[i]);
    if (search.is_done()) return false;
  }
  return true;
}

void BspTree::traverse(Search& search) const {
  const PreparedRay& ray = search.ray;
  Mailboxes mailboxes;
  if (ray.margin * 16.0 > pad_) {
    for (const std::uint32_t id : all_) {
      search.test(id);
      if (search.is_done()) return;
    }
    return;
  }
  std::array<Visit, 64> stack;
  std::size_t waiting = 0;
  // The whole line, not only what is wanted of it: where a ray grazes a triangle, its t is known less well
  // than where it is. What is wanted is asked of the boxes.
  stack[waiting++] = {0, ray.through(bounds().lower, bounds().upper)};
  while (waiting > 0) {
    const Visit visit = stack[--waiting];
    const Node& node = nodes_[visit.node];
    ++search.counters.boxes;
    const Interval box = ray.through(node.box.lower, node.box.upper);
    const Interval wanted = intersect(box, {ray.range.lower, search.limit()});
    if (node.box.is_empty() || wanted.is_empty()) continue;
    ++search.counters.nodes;
    if (!test(node, search, mailboxes)) return;
    if (node.is_leaf()) continue;
    const double begin = node.height(ray.ray.at(visit.inside.lower));
    const double end = node.height(ray.ray.at(visit.inside.upper));
    const bool begins_positive = begin >= 0.0;
    const std::uint32_t near = begins_positive ? node.positive : node.negative;
    const std::uint32_t far = begins_positive ? node.negative : node.positive;
    if ((end >= 0.0) == begins_positive) {
      stack[waiting++] = {near, visit.inside};
      continue;
    }
    const double share = begin / (begin - end);
    const double crossing = visit.inside.lower + (visit.inside.upper - visit.inside.lower) * share;
    stack[waiting++] = {far, {crossing, visit.inside.upper}};
    stack[waiting++] = {near, {visit.inside.lower, crossing}};
  }
}

}  // namespace velum
