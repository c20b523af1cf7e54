#pragma once

#include <cstdint>

namespace velum {

/// What hangs below a child of a wide node: nothing, a node, or a block of one to four triangles.
class WideReference {
 public:
  /// Of no meaning; does nothing, since every ray has a stack of these.
  WideReference() = default;
  static WideReference to_node(std::uint32_t index) { return WideReference(index); }
  /// @pre 1 ≤ triangles ≤ 4, index < 2^29
  static WideReference to_block(std::uint32_t index, std::uint32_t triangles) {
    return WideReference(leaf_bit | (triangles - 1u) << 29 | index);
  }

  bool is_block() const { return (bits_ & leaf_bit) != 0; }
  std::uint32_t index() const { return is_block() ? bits_ & 0x1FFFFFFFu : bits_; }
  std::uint32_t triangles() const { return (bits_ >> 29 & 3u) + 1u; }

 private:
  static constexpr std::uint32_t leaf_bit = 0x80000000u;
  explicit WideReference(std::uint32_t bits) : bits_(bits) {}
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

/// No path from the root has more nodes.
inline constexpr int wide_most_depth = 80;

/// A tree for kernels, which know no containers.
struct WideTreeView {
  const WideNode* nodes;
  const TriangleBlock* blocks;
  WideReference root;
};

}  // namespace velum
