#pragma once

#include <cstdint>

#include "../../base/isa.hpp"
#include "wide_nodes.hpp"

namespace velum {

/// A ray as the vector kernels meet boxes and triangles with it. Boxes are met in float32 and as if larger by
/// a margin for all rounding of float32; see wide_ray.hpp.
struct WideRay {
  float near_from[3];         ///< from where the sides that are entered first are seen, x, y, z
  float far_from[3];          ///< the others
  float inverse[3];           ///< 1 / direction, scaled so that the longest axis has ±1
  std::uint32_t near_row[3];  ///< in WideNode::bounds, by the direction's signs
  std::uint32_t far_row[3];
  float lower, upper;  ///< the scaled t that are wanted
  // As PreparedRay.
  double origin[3];  ///< along kx, ky, kz
  double shear_x, shear_y;
  std::uint32_t axis[3];  ///< kx, ky, kz
};

/// Told which triangles of a block the ray meets, or perhaps meets.
struct WideMeeting {
  void* context;
  /// @return the scaled t up to which hits are wanted from now on; -infinity: none
  float (*meet)(void* context, const TriangleBlock& block, std::uint32_t lanes);
};

struct WideCounts {
  std::uint64_t nodes = 0, boxes = 0, tests = 0;
};

/// Takes a ray through a tree, nearer boxes first. @pre the tree is not empty
using TraverseWide = void (*)(const WideTreeView& tree, const WideRay& ray, const WideMeeting& meeting,
                              WideCounts& counts);

/// @pre is_available(isa), and not `reference`
TraverseWide traverse_wide_kernel(Isa isa);

}  // namespace velum
