#pragma once

#include <cstdint>

namespace velum {

/// What hangs below a child of a wide node: nothing, a node, or a block of one to four triangles. Says in
/// which place of memory, in steps of 32 bytes, so that kernels need not multiply.
class WideReference {
 public:
  static constexpr std::uint32_t most_nodes = 0x80000000u / 7u, most_blocks = 0x20000000u / 5u;

  /// Of no meaning; does nothing, since every ray has a stack of these.
  WideReference() = default;
  explicit WideReference(std::uint32_t bits) : bits_(bits) {}
  /// @pre index < most_nodes
  static WideReference to_node(std::uint32_t index) { return WideReference(node_steps * index); }
  /// @pre 1 ≤ triangles ≤ 4, index < most_blocks
  static WideReference to_block(std::uint32_t index, std::uint32_t triangles) {
    return WideReference(leaf_bit | (triangles - 1u) << 29 | block_steps * index);
  }

  bool is_block() const { return (bits_ & leaf_bit) != 0; }
  std::uint32_t index() const { return is_block() ? steps() / block_steps : steps() / node_steps; }
  std::uint32_t triangles() const { return (bits_ >> 29 & 3u) + 1u; }
  /// From the first node, or the first block, on; in steps of 32 bytes.
  std::uint32_t steps() const { return bits_ & 0x7FFFFFFFu >> (bits_ >> 31) * 2; }  // no branch: it varies
  std::uint32_t bits() const { return bits_; }

 private:
  static constexpr std::uint32_t leaf_bit = 0x80000000u;
  static constexpr std::uint32_t node_steps = 7, block_steps = 5;
  std::uint32_t bits_;
};

/// Eight boxes side by side, so that vectors meet them at once; 224 bytes. Unused places have empty boxes,
/// lower = infinity and upper = -infinity.
struct alignas(32) WideNode {
  float bounds[6][8];  ///< lower x, y, z, upper x, y, z
  WideReference child[8];
};

/// Up to four triangles side by side with their corners, which are copies: a leaf is one piece of memory.
struct alignas(32) TriangleBlock {
  float corner[3][3][4];  ///< corner, axis, triangle; NaN where there is none
  std::uint32_t id[4];    ///< no_triangle where there is none
};

static_assert(sizeof(WideNode) == 7 * 32 && sizeof(TriangleBlock) == 5 * 32);

/// No path from the root has more nodes.
inline constexpr int wide_most_depth = 80;

/// A tree for kernels, which know no containers.
struct WideTreeView {
  const WideNode* nodes;
  const TriangleBlock* blocks;
  WideReference root;
};

}  // namespace velum
