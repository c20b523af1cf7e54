#include "octree.hpp"

#include <algorithm>
#include <array>

namespace velum {
namespace {

bool is_finite(const glm::dvec3& v) {
  const double sum = (v.x - v.x) + (v.y - v.y) + (v.z - v.z);
  return sum == 0.0;
}

/// The child of a cube: bits 0, 1, 2 choose the upper half in x, y, z. 8: the cube itself.
constexpr unsigned own = 8;

struct Cube {
  glm::dvec3 centre;
  double half = 0.0;  ///< of its side

  Cube child(unsigned octant) const {
    const double quarter = half * 0.5;
    return {{centre.x + ((octant & 1u) ? quarter : -quarter), centre.y + ((octant & 2u) ? quarter : -quarter),
             centre.z + ((octant & 4u) ? quarter : -quarter)},
            quarter};
  }
};

unsigned octant_of(const glm::dvec3& point, const Cube& cube) {
  return (point.x >= cube.centre.x ? 1u : 0u) | (point.y >= cube.centre.y ? 2u : 0u) |
         (point.z >= cube.centre.z ? 4u : 0u);
}

unsigned place_of(const Aabb& box, const Cube& cube, OctreePlacement placement) {
  if (placement == OctreePlacement::pushed_down) return octant_of(box.centre(), cube);
  const unsigned lower = octant_of(box.lower, cube);
  return lower == octant_of(box.upper, cube) ? lower : own;
}

}  // namespace

struct Octree::Builder {
  Octree& tree;
  std::span<const Aabb> boxes;
  const OctreeOptions& options;
  std::vector<std::uint32_t> sorted{};  ///< scratch

  /// Where the parts of a node's items end after sort(): its own, then those of the eight children.
  using Ends = std::array<std::uint32_t, 9>;

  /// Sorts items first … end-1 by their place in the cube.
  Ends sort(const Cube& cube, std::uint32_t first, std::uint32_t end) {
    std::array<std::uint32_t, 9> next{};
    const auto part = [&](std::uint32_t i) {
      return (place_of(boxes[tree.items_[i]], cube, options.placement) + 1) % 9;  // its own come first
    };
    for (std::uint32_t i = first; i < end; ++i) ++next[part(i)];
    std::uint32_t sum = first;
    for (std::uint32_t& count : next) {
      sum += count;
      count = sum - count;
    }
    sorted.resize(tree.items_.size());
    for (std::uint32_t i = first; i < end; ++i) sorted[next[part(i)]++] = tree.items_[i];
    std::copy(sorted.begin() + first, sorted.begin() + end, tree.items_.begin() + first);
    return next;
  }

  /// The child that has all the items, so that the cube needs no node; `own` if there is none.
  static unsigned only_child(const Ends& ends, std::uint32_t first, std::uint32_t end) {
    unsigned octant = 0;
    while (octant < own && (ends[octant] != first || ends[octant + 1] != end)) ++octant;
    return octant;
  }

  Aabb box_of(std::uint32_t first, std::uint32_t end) const {
    Aabb box;
    for (std::uint32_t i = first; i < end; ++i) box.include(boxes[tree.items_[i]]);
    return box;
  }

  /// Divides node `index`, whose items and box stand, until its leaves are small enough.
  void divide(std::uint32_t index, Cube cube, int level, int nodes_above) {
    const std::uint32_t first = tree.nodes_[index].first, end = tree.nodes_[index].end;
    tree.depth_ = std::max(tree.depth_, nodes_above + 1);
    Ends ends{};
    for (;; ++level) {
      if (end - first <= options.leaf_size || level >= options.most_levels) return;
      ends = sort(cube, first, end);
      const unsigned only = only_child(ends, first, end);
      if (only == own) break;
      cube = cube.child(only);
    }
    tree.nodes_[index].own_end = ends[0];
    tree.nodes_[index].first_child = static_cast<std::uint32_t>(tree.nodes_.size());
    std::array<unsigned, 8> octants{};
    std::uint32_t count = 0;
    for (unsigned octant = 0; octant < 8; ++octant) {
      if (ends[octant] == ends[octant + 1]) continue;
      octants[count++] = octant;
      tree.nodes_.push_back(
          {box_of(ends[octant], ends[octant + 1]), 0, 0, ends[octant], ends[octant + 1], ends[octant + 1]});
    }
    tree.nodes_[index].child_count = count;
    const std::uint32_t first_child = tree.nodes_[index].first_child;
    for (std::uint32_t i = 0; i < count; ++i) {
      divide(first_child + i, cube.child(octants[i]), level + 1, nodes_above + 1);
    }
  }
};

Octree::Octree(std::span<const Aabb> boxes, const OctreeOptions& options) {
  Aabb all;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const bool has_place = !boxes[i].is_empty() && is_finite(boxes[i].lower) && is_finite(boxes[i].upper);
    (has_place ? items_ : loose_).push_back(i);
    if (has_place) all.include(boxes[i]);
  }
  if (items_.empty()) return;
  const auto count = static_cast<std::uint32_t>(items_.size());
  nodes_.push_back({all, 0, 0, 0, count, count});
  const glm::dvec3 size = all.size();
  Builder{*this, boxes, options}.divide(0, {all.centre(), 0.5 * std::max({size.x, size.y, size.z})}, 1, 0);
  nodes_.shrink_to_fit();
}

std::size_t Octree::bytes() const {
  return nodes_.capacity() * sizeof(OctreeNode) +
         (items_.capacity() + loose_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace velum
