#include "wide_packet_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/wide_packet_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"
#include "wide_packet-inl.hpp"
#include "wide_stack-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// Leaves, once the rays are prepared for triangles.
struct PacketLeaves {
  const PacketMeeting& meeting;
  const WideLines& lines;
  PacketBeam beam;

  /// @return the t up to which hits are wanted from now on
  HWY_INLINE float visit(const TriangleBlock& block, float upper, std::uint64_t& tests) const {
    std::uint32_t near = beam.perhaps_met(block);
    while (near != 0) {
      const std::size_t triangle = take_lowest(near);
      if (block.id[triangle] == 0xFFFFFFFFu) break;
      tests += WidePacket::size;
      const std::uint32_t lanes = rays_that_meet(block, triangle, lines);
      if (lanes != 0)
        upper = meeting.meet(meeting.context, block, static_cast<std::uint32_t>(triangle), lanes);
    }
    return upper;
  }
};

/// The rest of the way, from the first leaf on.
void visit_leaves(const WideTreeView& tree, const BoxPacket& box_packet, const PacketLeaves& leaves,
                  WideReference current, float upper, Stack& stack, WideCounts& counts) {
  for (bool is_left = true; is_left;) {
    ++counts.nodes;
    if (current.is_block()) {
      upper = leaves.visit(tree.blocks[current.index()], upper, counts.tests);
    } else {
      counts.boxes += 8;
      const WideNode& node = tree.nodes[current.index()];
      HWY_ALIGN float entry[8];
      const std::uint32_t mask = entered(box_packet, node, upper, entry);
      if (mask != 0) {
        current = nearest(tree, node, mask, entry, stack);
        continue;
      }
    }
    is_left = take_next(stack, upper, current);
  }
}

/// Through inner nodes only. @return false: there is no leaf to visit
HWY_INLINE bool find_leaf(const WideTreeView& tree, const BoxPacket& box_packet, float upper, Stack& stack,
                          WideReference& current, WideCounts& counts) {
  while (!current.is_block()) {
    ++counts.nodes;
    counts.boxes += 8;
    const WideNode& node = tree.nodes[current.index()];
    HWY_ALIGN float entry[8];
    const std::uint32_t mask = entered(box_packet, node, upper, entry);
    if (mask != 0) {
      current = nearest(tree, node, mask, entry, stack);
    } else if (!take_next(stack, upper, current)) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool traverse_packet(const WideTreeView& tree, const WidePacket& packet, const PacketMeeting& meeting,
                     WideCounts& counts) {
  const PacketFrustum frustum(packet);
  if (!frustum.is_usable) return false;
  const BoxPacket box_packet(frustum);
  Stack stack;
  WideReference current = tree.root;
  WideCounts seen;
  if (find_leaf(tree, box_packet, frustum.upper, stack, current, seen)) {
    const WideLines* lines = meeting.prepare(meeting.context);
    if (lines == nullptr) return false;
    const PacketLeaves leaves{meeting, *lines, PacketBeam(packet, frustum)};
    visit_leaves(tree, box_packet, leaves, current, frustum.upper, stack, seen);
  }
  counts.nodes += seen.nodes;
  counts.boxes += seen.boxes;
  counts.tests += seen.tests;
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

TraversePacket traverse_packet_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(traverse_packet);
  return versions.at(isa);
}

}  // namespace velum
#endif
