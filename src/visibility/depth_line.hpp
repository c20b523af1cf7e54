#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "../projection/viewport.hpp"
#include "depth_plane.hpp"

namespace velum {

/// The depth of a segment as a function of the pixel along its major axis, constant across it: a DepthPlane
/// with one slope only. Like a triangle's, it comes from the *unclipped, unsnapped* homogeneous ends, so
/// clipping never changes a depth and w ≤ 0 needs none; it is clamped to the ends' range (to [0, 1] where
/// some w ≤ 0). Swapping the ends changes no bit.
///
/// The reference pixel holds the farther end, as in depth_plane(). Where the line runs exactly across the
/// major axis, or too steeply for float32, the depth is that of the nearer end everywhere.
///
/// @param segment   clip space, finite, at least one w > 0
/// @param x_major   whether columns (else rows) are counted along the segment, see is_x_major()
DepthPlane depth_line(const std::array<glm::dvec4, 2>& segment, bool x_major, const Viewport& viewport);

/// A point's depth: the same at every pixel. @pre clip space, finite, w > 0
DepthPlane depth_of_point(const glm::dvec4& point);

}  // namespace velum
