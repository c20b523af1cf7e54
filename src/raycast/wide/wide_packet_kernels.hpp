#pragma once

#include "wide_cast_kernels.hpp"

namespace velum {

/// Eight rays, and who is asked about them.
struct PacketQuery {
  static constexpr std::size_t size = 8;
  const double* rays;  ///< each: origin, direction, and the least and the largest t that are wanted
  std::size_t count;   ///< 1 … 8; of fewer the last one is repeated
  const WideBounds* bounds;
  void* context;  ///< for `decide`
  /// Whether a triangle counts; nullptr: all do.
  bool (*accepts)(const void* context, std::uint32_t triangle);
  const void* filter_context;
  /// As WideQuery::decide, for one of the rays.
  bool (*decide)(void* context, const TriangleBlock& block, std::size_t lane, std::size_t ray, WideHit& hit);

  const double* ray(std::size_t i) const { return rays + 8 * (i < count ? i : count - 1); }
};

/// The hits of eight rays; see RayHit.
struct PacketHits {
  alignas(64) double t[PacketQuery::size];
  alignas(64) double triangle[PacketQuery::size];
  alignas(64) double barycentric[3][PacketQuery::size];
};

enum class PacketOutcome {
  refused,  ///< the rays have not enough in common; nothing was decided
  missed,   ///< no ray comes near a triangle; the hits are not set
  cast
};

/// Takes eight rays through a tree together. Boxes are met by the interval of all origins and the interval of
/// all inverse directions (Boulos, Wald & Shirley 2006, "Geometric and Arithmetic Culling Methods for Entire
/// Ray Packets"), so they cost as if for one ray; blocks of triangles are first held against the four planes
/// around the rays; what is left is decided for eight rays at once by the operations of
/// intersect_watertight().
/// @pre the tree is not empty
using TraversePacket = PacketOutcome (*)(const WideTreeView& tree, const PacketQuery& query, PacketHits& hits,
                                         WalkCounts& counts);

/// @pre is_available(isa), and not `reference`
TraversePacket traverse_packet_kernel(Isa isa);

}  // namespace velum
