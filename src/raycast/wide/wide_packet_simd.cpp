#include "wide_packet_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/wide/wide_packet_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/highway.h>

#include "../../base/simd_dispatch.hpp"
#include "wide_beam-inl.hpp"
#include "wide_packet-inl.hpp"
#include "wide_packet_exact-inl.hpp"
#include "wide_stack-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// Leaves, once the rays are prepared for triangles.
struct PacketLeaves {
  PacketBeam beam;
  FirstHits first_hits;

  /// @return the t up to which hits are wanted from now on
  HWY_INLINE float visit(const TriangleBlock& block, float upper, std::uint64_t& tests) {
    bool is_hit = false;
    for (std::uint32_t near = beam.perhaps_met(block); near != 0;) {
      const std::size_t triangle = take_lowest(near);
      if (block.id[triangle] == 0xFFFFFFFFu) break;
      tests += PacketQuery::size;
      is_hit |= first_hits.test(block, triangle);
    }
    return is_hit ? first_hits.upper() : upper;
  }
};

/// The rest of the way, from the first leaf on.
void visit_leaves(const Places& places, const BoxPacket& box_packet, PacketLeaves& leaves,
                  WideReference current, float upper, Stack& stack, WalkCounts& counts) {
  for (bool is_left = true; is_left;) {
    ++counts.nodes;
    if (current.is_block()) {
      upper = leaves.visit(places.block(current), upper, counts.tests);
    } else {
      counts.boxes += 8;
      const WideNode& node = places.node(current);
      HWY_ALIGN float entry[8];
      const std::uint32_t mask = entered(box_packet, node, upper, entry);
      if (mask != 0) {
        current = nearest(places, node, mask, entry, stack);
        continue;
      }
    }
    is_left = take_next(stack, upper, current);
  }
}

/// Through inner nodes only. @return false: there is no leaf to visit
HWY_INLINE bool find_leaf(const Places& places, const BoxPacket& box_packet, float upper, Stack& stack,
                          WideReference& current, WalkCounts& counts) {
  while (!current.is_block()) {
    ++counts.nodes;
    counts.boxes += 8;
    const WideNode& node = places.node(current);
    HWY_ALIGN float entry[8];
    const std::uint32_t mask = entered(box_packet, node, upper, entry);
    if (mask != 0) {
      current = nearest(places, node, mask, entry, stack);
    } else if (!take_next(stack, upper, current)) {
      return false;
    }
  }
  return true;
}

}  // namespace

PacketOutcome traverse_packet(const WideTreeView& tree, const PacketQuery& query, PacketHits& hits,
                              WalkCounts& counts) {
  const PacketFrustum frustum(query);
  if (!frustum.is_usable) return PacketOutcome::refused;
  const BoxPacket box_packet(frustum);
  Stack stack;
  const Places places(tree);
  WideReference current = tree.root;
  WalkCounts seen;
  const bool has_leaf = find_leaf(places, box_packet, frustum.upper, stack, current, seen);
  if (has_leaf) {
    PacketLines lines;
    if (!lines.set(query)) return PacketOutcome::refused;
    PacketLeaves leaves{PacketBeam(query, frustum, lines), FirstHits(query, lines, hits)};
    visit_leaves(places, box_packet, leaves, current, frustum.upper, stack, seen);
  }
  counts.nodes += seen.nodes;
  counts.boxes += seen.boxes;
  counts.tests += seen.tests;
  return has_leaf ? PacketOutcome::cast : PacketOutcome::missed;
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
