#include "octree_caster.hpp"

#include <array>

namespace velum {
namespace {

Octree tree_over(const TriangleSet& triangles, const std::vector<BoxedItem>& items,
                 const OctreeOptions& options) {
  std::vector<Aabb> boxes(triangles.size());  // empty ones have no place in the tree
  for (const BoxedItem& item : items) {
    boxes[item.id] = {glm::dvec3(item.box.lower), glm::dvec3(item.box.upper)};
  }
  return Octree(boxes, options);
}

struct Waiting {
  std::uint32_t node;
  double entry;
};

/// Nodes to visit, the next one last.
class Agenda {
 public:
  bool is_empty() const { return size_ == 0; }
  void push(const Waiting& waiting) { waiting_[size_++] = waiting; }
  Waiting pop() { return waiting_[--size_]; }
  std::size_t size() const { return size_; }

  /// Sorts those from place `first` on: the one that is entered first comes last.
  void sort_from(std::size_t first) {
    for (std::size_t i = first + 1; i < size_; ++i) {
      for (std::size_t k = i; k > first && waiting_[k - 1].entry < waiting_[k].entry; --k) {
        std::swap(waiting_[k - 1], waiting_[k]);
      }
    }
  }

 private:
  std::array<Waiting, 8 * 64> waiting_;
  std::size_t size_ = 0;
};

}  // namespace

OctreeCaster::OctreeCaster(const TriangleSet& triangles, const OctreeOptions& options)
    : Accelerator(triangles), tree_(tree_over(triangles, boxed_triangles(), options)) {}

void OctreeCaster::traverse(Search& search) const {
  const PreparedRay& ray = search.ray;
  const std::vector<OctreeNode>& nodes = tree_.nodes();
  Agenda agenda;
  agenda.push({0, ray.range.lower});
  while (!agenda.is_empty()) {
    const Waiting next = agenda.pop();
    if (next.entry > search.limit()) continue;
    const OctreeNode& node = nodes[next.node];
    ++search.counters.nodes;
    for (std::uint32_t i = node.first; i < node.own_end; ++i) {
      search.test(tree_.items()[i]);
      if (search.is_done()) return;
    }
    const std::size_t first = agenda.size();
    search.counters.boxes += node.child_count;
    for (std::uint32_t c = node.first_child; c < node.first_child + node.child_count; ++c) {
      const Interval inside = intersect(ray.through(nodes[c].box.lower, nodes[c].box.upper), ray.range);
      if (!inside.is_empty() && inside.lower <= search.limit()) agenda.push({c, inside.lower});
    }
    agenda.sort_from(first);
  }
}

}  // namespace velum
