#pragma once

#include <glm/vec4.hpp>

#include "clip_volume.hpp"

namespace velum {

/// Where an edge crosses a plane of the view volume.
struct Cut {
  glm::dvec4 point;  ///< homogeneous clip space
  double t;          ///< parameter from the inside (0) to the outside end (1), linear in clip space
};

/// Cuts the edge from `in` to `out` at plane i of the volume. The result depends on the two ends and the
/// plane only, not on the polygon, the direction of travel or the planes before, so everything that shares
/// the edge gets the same bits.
/// @pre  both ends finite; `in` strictly inside plane i, `out` strictly outside
/// @post the point lies exactly on plane i; it is inside every plane both ends are inside of; each coordinate
///       not moved by these rules lies between those of the ends
Cut cut_edge(const glm::dvec4& in, const glm::dvec4& out, ClipPlane plane, const ClipVolume& volume = {});

/// Neither NaN nor infinite.
bool is_finite(const glm::dvec4& v);

}  // namespace velum
