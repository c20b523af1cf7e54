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

/// A part of the tree that is still to be visited, and where the ray enters it: in one number, which goes to
/// memory and back as one, the entry above the part. Of two parts the smaller number is nearer, or, where
/// both are entered at t < 0, farther: of no consequence but for time.
class Waiting {
 public:
  Waiting() = default;
  HWY_INLINE Waiting(float entry, WideReference below) {
    std::uint32_t bits;
    hwy::CopyBytes<sizeof(bits)>(&entry, &bits);
    number_ = static_cast<std::int64_t>(std::uint64_t{bits} << 32 | below.bits());
  }
  HWY_INLINE float entry() const {
    const auto bits = static_cast<std::uint32_t>(static_cast<std::uint64_t>(number_) >> 32);
    float result;
    hwy::CopyBytes<sizeof(bits)>(&bits, &result);
    return result;
  }
  HWY_INLINE WideReference below() const { return WideReference(static_cast<std::uint32_t>(number_)); }
  HWY_INLINE bool operator<(const Waiting& other) const { return number_ < other.number_; }

 private:
  std::int64_t number_;
};

/// Puts the nearer one first; no branch, since nobody can guess which it is.
HWY_INLINE void put_in_order(Waiting& nearer, Waiting& farther) {
  const bool is_wrong = farther < nearer;
  const Waiting one = is_wrong ? farther : nearer, other = is_wrong ? nearer : farther;
  nearer = one;
  farther = other;
}

/// What waits, the nearest last.
class Stack {
 public:
  HWY_INLINE bool is_empty() const { return size_ == 0; }
  HWY_INLINE Waiting pop() { return all_[--size_]; }
  HWY_INLINE void push(Waiting part) { all_[size_++] = part; }
  HWY_INLINE std::size_t size() const { return size_; }
  /// Puts a part among those from `bottom` on.
  HWY_INLINE void insert(Waiting part, std::size_t bottom) {
    std::size_t place = size_++;
    for (; place > bottom && all_[place - 1] < part; --place) all_[place] = all_[place - 1];
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

/// Where nodes and blocks lie.
class Places {
 public:
  HWY_INLINE explicit Places(const WideTreeView& tree)
      : first_{reinterpret_cast<const char*>(tree.nodes), reinterpret_cast<const char*>(tree.blocks)} {}
  HWY_INLINE const WideNode& node(WideReference part) const {
    return *reinterpret_cast<const WideNode*>(first_[0] + std::size_t{32} * part.bits());
  }
  HWY_INLINE const TriangleBlock& block(WideReference part) const {
    return *reinterpret_cast<const TriangleBlock*>(first_[1] + std::size_t{32} * (part.bits() & 0x1FFFFFFFu));
  }
  /// Asks for the memory of a part: it is there, or on its way, when the branches are sorted out.
  HWY_INLINE void ask_for(WideReference part) const {
    const char* memory = first_[part.bits() >> 31] + std::size_t{32} * part.steps();
    for (std::size_t line = 0; line < 4; ++line) hwy::Prefetch(memory + 64 * line);
  }

 private:
  const char* first_[2];
};

/// The nearest of the children that are entered; the others wait. @pre mask != 0
HWY_INLINE WideReference nearest(const Places& places, const WideNode& node, std::uint32_t mask,
                                 const float* entry, Stack& stack) {
  const auto take_child = [&] {
    const std::size_t child = take_lowest(mask);
    return Waiting(entry[child], node.child[child]);
  };
  Waiting first = take_child();
  places.ask_for(first.below());
  if (mask == 0) return first.below();
  Waiting second = take_child();
  places.ask_for(second.below());
  put_in_order(first, second);
  if (mask == 0) {
    stack.push(second);
    return first.below();
  }
  Waiting third = take_child();
  put_in_order(second, third);
  put_in_order(first, second);
  const std::size_t bottom = stack.size();
  stack.push(third);
  stack.push(second);
  if (mask == 0) return first.below();
  stack.push(first);
  do {
    stack.insert(take_child(), bottom);
  } while (mask != 0);
  return stack.pop().below();
}

/// Takes the next part from the stack that is entered at `upper` or before. @return false: there is none
HWY_INLINE bool take_next(Stack& stack, float upper, WideReference& next) {
  while (!stack.is_empty()) {
    const Waiting part = stack.pop();
    next = part.below();
    if (part.entry() <= upper) return true;
  }
  return false;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
