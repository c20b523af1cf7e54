#include <algorithm>
#include <array>

#include "wide_bvh.hpp"

namespace velum {
namespace {

struct Waiting {
  double entry;
  WideReference below;
};

/// The children that the ray goes into, the nearest last. @return how many
std::size_t enter(const WideNode& node, const Search& search, Waiting* waiting) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto corner = [&](std::size_t row) {
      return glm::vec3(node.bounds[row][i], node.bounds[row + 1][i], node.bounds[row + 2][i]);
    };
    if (corner(0).x > corner(3).x) continue;  // unused
    const Interval inside = intersect(search.ray.through(corner(0), corner(3)), search.ray.range);
    if (inside.is_empty() || inside.lower > search.limit()) continue;
    waiting[count++] = {inside.lower, node.child[i]};
  }
  std::stable_sort(waiting, waiting + count,
                   [](const Waiting& a, const Waiting& b) { return a.entry > b.entry; });
  return count;
}

void test(const TriangleBlock& block, std::size_t count, Search& search) {
  for (std::size_t lane = 0; lane < count && !search.is_done(); ++lane) {
    search.decide(block.id[lane], triangle_in(block, lane));
  }
}

}  // namespace

void traverse_wide_reference(const WideTree& tree, Search& search) {
  std::array<Waiting, 7 * wide_most_depth + 8> stack;
  stack[0] = {search.ray.range.lower, tree.root};
  std::size_t waiting = 1;
  while (waiting != 0 && !search.is_done()) {
    const Waiting next = stack[--waiting];
    if (next.entry > search.limit()) continue;
    ++search.counters.nodes;
    const std::uint32_t index = next.below.index();
    if (next.below.is_block()) {
      search.counters.tests += next.below.triangles();
      test(tree.blocks[index], next.below.triangles(), search);
    } else {
      search.counters.boxes += 8;
      waiting += enter(tree.nodes[index], search, stack.data() + waiting);
    }
  }
}

}  // namespace velum
