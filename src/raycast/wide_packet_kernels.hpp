#pragma once

#include "wide_kernels.hpp"

namespace velum {

/// Eight rays. A packet of fewer repeats its last one.
struct WidePacket {
  static constexpr std::uint32_t size = 8;
  const double* ray[size];  ///< each: origin, direction, and the least and the largest t that are wanted
  float bounds[2][3];       ///< of the tree: lower, upper
};

/// The same rays as intersect_watertight() sees them, exact; they share the axes.
struct WideLines {
  alignas(64) double origin[3][WidePacket::size];  ///< along kx, ky, kz
  alignas(64) double shear_x[WidePacket::size];
  alignas(64) double shear_y[WidePacket::size];
  std::uint32_t axis[3];  ///< kx, ky, kz
};

/// Who prepares the rays, when it comes to triangles, and decides about hits.
struct PacketMeeting {
  void* context;
  /// @return nullptr if the rays do not share their axes
  const WideLines* (*prepare)(void* context);
  /// The rays of `lanes` meet, or perhaps meet, a triangle of the block.
  /// @return the t up to which hits are wanted from now on, the largest of all rays', rounded up
  float (*meet)(void* context, const TriangleBlock& block, std::uint32_t triangle, std::uint32_t lanes);
};

/// Takes eight rays through a tree together. Boxes are met by the interval of all origins and the interval of
/// all inverse directions (Boulos, Wald & Shirley 2006, "Geometric and Arithmetic Culling Methods for Entire
/// Ray Packets"), so they cost as if for one ray; blocks of triangles are first held against the four planes
/// around the rays.
/// @return false: the rays have not enough in common, and nothing was decided about them
/// @pre the tree is not empty
using TraversePacket = bool (*)(const WideTreeView& tree, const WidePacket& packet,
                                const PacketMeeting& meeting, WideCounts& counts);

/// @pre is_available(isa), and not `reference`
TraversePacket traverse_packet_kernel(Isa isa);

}  // namespace velum
