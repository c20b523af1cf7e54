#pragma once

#include "../projection/camera.hpp"
#include "depth_format.hpp"

namespace velum {

/// The smallest step of depth that a format can tell at a distance: from the value it keeps for a surface
/// there to its next farther value (at the far plane: to its next nearer one), in world units along the look
/// vector. Infinite where that value stands for infinity (a far plane at infinity).
///
/// This is what the format can hold; evaluating the plane in float32 adds rounding of its own, which matters
/// for `reversed` only: near r = 0 its steps are far below any scene.
///
/// @param metric_depth  world units; taken to the camera's near or far plane if outside
double depth_resolution_at(const Camera& camera, DepthFormat format, double metric_depth);

}  // namespace velum
