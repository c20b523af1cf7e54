#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string>

#include "../../base/error.hpp"
#include "wide_build_kernels.hpp"
#include "wide_tree.hpp"

namespace velum {
namespace {

constexpr std::uint32_t block_size = 4;
/// Below this depth items are halved, whatever it costs: bounds every path.
constexpr int steps_of_rule = 40;
constexpr std::uint32_t no_id = 0xFFFFFFFFu;

bool is_finite(const glm::vec3& p) {
  return (p.x - p.x) + (p.y - p.y) + (p.z - p.z) == 0.0f;
}

std::vector<BuildItem> items_of(const TriangleSet& set) {
  std::vector<BuildItem> items;
  items.reserve(set.size());
  for (std::uint32_t i = 0; i < set.size(); ++i) {
    const glm::uvec3& v = set.triangles[i];
    const glm::vec3 &a = set.positions[v.x], &b = set.positions[v.y], &c = set.positions[v.z];
    if (!is_finite(a) || !is_finite(b) || !is_finite(c)) continue;
    const glm::vec3 lower = glm::min(glm::min(a, b), c), upper = glm::max(glm::max(a, b), c);
    items.push_back({{lower.x, lower.y, lower.z, std::bit_cast<float>(i), -upper.x, -upper.y, -upper.z, 0}});
  }
  return items;
}

class WideBuilder {
 public:
  WideBuilder(const TriangleSet& set, Isa isa)
      : set_(set), kernels_(wide_build_kernels(isa)), items_(items_of(set)) {}

  WideTree run() {
    if (items_.empty()) return {};
    tree_.blocks.reserve(items_.size() / 3);
    BuildRange all;
    all.end = static_cast<std::uint32_t>(items_.size());
    kernels_.measure(items_.data(), all);
    tree_.root = build(all, 0);
    tree_.nodes.shrink_to_fit();
    tree_.blocks.shrink_to_fit();
    return std::move(tree_);
  }

 private:
  struct Children {
    std::array<BuildRange, 8> ranges;
    std::size_t count = 0;
  };

  WideReference build(const BuildRange& range, int depth) {
    if (range.size() <= block_size) return add_block(range);
    const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes.emplace_back();
    const Children children = divide(range, depth);
    set_boxes(tree_.nodes[index], children);
    for (std::size_t i = 0; i < children.count; ++i) {
      const WideReference below = build(children.ranges[i], depth + 1);
      tree_.nodes[index].child[i] = below;
    }
    return WideReference::to_node(index);
  }

  Children divide(const BuildRange& range, int depth) {
    Children children;
    children.ranges[children.count++] = range;
    while (children.count < 8) {
      BuildRange* largest = nullptr;
      for (std::size_t i = 0; i < children.count; ++i) {
        BuildRange& child = children.ranges[i];
        if (child.size() <= block_size) continue;
        if (largest == nullptr || child.box.half_area() > largest->box.half_area()) largest = &child;
      }
      if (largest == nullptr) break;
      const BuildRange parent = *largest;
      BuildRange& right = children.ranges[children.count++];
      if (depth >= steps_of_rule || !kernels_.split(items_.data(), parent, *largest, right)) {
        halve(parent, *largest, right);
      }
    }
    return children;
  }

  void halve(const BuildRange& range, BuildRange& left, BuildRange& right) {
    const std::uint32_t middle = range.begin + range.size() / 2;
    left.begin = range.begin;
    left.end = right.begin = middle;
    right.end = range.end;
    kernels_.measure(items_.data(), left);
    kernels_.measure(items_.data(), right);
  }

  static void set_boxes(WideNode& node, const Children& children) {
    constexpr float none = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < 8; ++i) {
      const bool is_used = i < children.count;
      const float* side = children.ranges[i].box.side;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.bounds[axis][i] = is_used ? side[axis] : none;
        node.bounds[3 + axis][i] = is_used ? -side[4 + axis] : -none;
      }
    }
  }

  WideReference add_block(const BuildRange& range) {
    const auto index = static_cast<std::uint32_t>(tree_.blocks.size());
    if (index >= WideReference::most_blocks) {
      throw Error(ErrorKind::limit, std::to_string(items_.size()) + " triangles are too many for one mesh",
                  "accelerator bvh", "divide the mesh");
    }
    TriangleBlock& block = tree_.blocks.emplace_back();
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      const bool is_used = lane < range.size();
      const std::uint32_t id =
          is_used ? std::bit_cast<std::uint32_t>(items_[range.begin + lane].side[3]) : no_id;
      block.id[lane] = id;
      for (glm::length_t corner = 0; corner < 3; ++corner) {
        const glm::vec3 p = is_used ? set_.positions[set_.triangles[id][corner]]
                                    : glm::vec3(std::numeric_limits<float>::quiet_NaN());
        for (glm::length_t axis = 0; axis < 3; ++axis) block.corner[corner][axis][lane] = p[axis];
      }
    }
    return WideReference::to_block(index, range.size());
  }

  const TriangleSet& set_;
  WideBuildKernels kernels_;
  std::vector<BuildItem> items_;
  WideTree tree_;
};

}  // namespace

WideTree build_wide_tree(const TriangleSet& triangles, Isa isa) {
  return WideBuilder(triangles, isa).run();
}

}  // namespace velum
