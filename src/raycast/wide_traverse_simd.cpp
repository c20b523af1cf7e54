#include "wide_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/wide_traverse_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"
#include "wide_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// A part of the tree that is still to be visited, and where the ray enters it.
struct Waiting {
  float entry;
  WideReference below;
};

/// What waits, the nearest last.
class Stack {
 public:
  HWY_INLINE bool is_empty() const { return size_ == 0; }
  HWY_INLINE const Waiting& pop() { return all_[--size_]; }
  HWY_INLINE void push(const Waiting& part) { all_[size_++] = part; }
  HWY_INLINE std::size_t size() const { return size_; }
  /// Puts a part among those from `bottom` on.
  HWY_INLINE void insert(const Waiting& part, std::size_t bottom) {
    std::size_t place = size_++;
    for (; place > bottom && all_[place - 1].entry < part.entry; --place) all_[place] = all_[place - 1];
    all_[place] = part;
  }

 private:
  std::size_t size_ = 0;
  Waiting all_[7 * wide_most_depth + 8];
};

/// Takes the lowest bit out. @pre there is one
HWY_INLINE std::size_t take_lowest(std::uint32_t& mask) {
  const std::size_t bit = hwy::Num0BitsBelowLS1Bit_Nonzero32(mask);
  mask &= mask - 1u;
  return bit;
}

/// The nearest of the children that are entered; the others wait.
HWY_INLINE WideReference nearest(const WideNode& node, std::uint32_t mask, const float* entry, Stack& stack) {
  const std::size_t first = take_lowest(mask);
  if (mask == 0) return node.child[first];
  const std::size_t second = take_lowest(mask);
  const std::size_t bottom = stack.size();
  const bool is_in_order = entry[first] <= entry[second];
  const std::size_t nearer = is_in_order ? first : second, farther = is_in_order ? second : first;
  stack.push({entry[farther], node.child[farther]});
  if (mask == 0) return node.child[nearer];
  stack.push({entry[nearer], node.child[nearer]});
  do {
    const std::size_t child = take_lowest(mask);
    stack.insert({entry[child], node.child[child]}, bottom);
  } while (mask != 0);
  return stack.pop().below;
}

}  // namespace

void traverse_wide(const WideTreeView& tree, const WideRay& ray, const WideMeeting& meeting,
                   WideCounts& counts) {
  const BoxRay box_ray(ray);
  const TriangleRay triangle_ray(ray);
  WideReference current = tree.root;
  std::uint64_t inner = 0, leaves = 0, tests = 0;
  float upper = ray.upper;
  Stack stack;
  for (bool is_left = true; is_left;) {
    if (!current.is_block()) {
      ++inner;
      const WideNode& node = tree.nodes[current.index()];
      HWY_ALIGN float entry[8];
      const std::uint32_t mask = box_ray.entered(node, upper, entry);
      if (mask != 0) {
        current = nearest(node, mask, entry, stack);
        continue;
      }
    } else {
      ++leaves;
      tests += current.triangles();
      const TriangleBlock& block = tree.blocks[current.index()];
      const std::uint32_t lanes = perhaps_met(block, triangle_ray);
      if (lanes != 0) upper = meeting.meet(meeting.context, block, lanes);
    }
    do {
      is_left = !stack.is_empty();
      if (!is_left) break;
      const Waiting& next = stack.pop();
      current = next.below;
      is_left = next.entry <= upper;
    } while (!is_left);
  }
  counts.nodes += inner + leaves;
  counts.boxes += 8 * inner;
  counts.tests += tests;
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

TraverseWide traverse_wide_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(traverse_wide);
  return versions.at(isa);
}

}  // namespace velum
#endif
