// What of a wide tree is still to be visited. Highway reads this file once per instruction set, so its guard
// turns with the target.
#if defined(VELUM_WIDE_STACK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_STACK_INL
#undef VELUM_WIDE_STACK_INL
#else
#define VELUM_WIDE_STACK_INL
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "wide_nodes.hpp"

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

/// Asks for the memory of a part: it is there, or on its way, when the branches are sorted out.
HWY_INLINE void ask_for(const WideTreeView& tree, WideReference part) {
  const auto* node = reinterpret_cast<const char*>(tree.nodes + part.index());
  const auto* block = reinterpret_cast<const char*>(tree.blocks + part.index());
  const char* memory = part.is_block() ? block : node;
  for (std::size_t line = 0; line < 4; ++line) hwy::Prefetch(memory + 64 * line);
}

/// The nearest of the children that are entered; the others wait.
HWY_INLINE WideReference nearest(const WideTreeView& tree, const WideNode& node, std::uint32_t mask,
                                 const float* entry, Stack& stack) {
  const std::size_t first = take_lowest(mask);
  ask_for(tree, node.child[first]);
  if (mask == 0) return node.child[first];
  const std::size_t second = take_lowest(mask);
  ask_for(tree, node.child[second]);
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

/// Takes the next part from the stack that is entered at `upper` or before. @return false: there is none
HWY_INLINE bool take_next(Stack& stack, float upper, WideReference& next) {
  while (!stack.is_empty()) {
    const Waiting& part = stack.pop();
    next = part.below;
    if (part.entry <= upper) return true;
  }
  return false;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
