#pragma once

#include <span>

#include "raster_target.hpp"
#include "screen_triangle.hpp"

namespace velum {

/// The z-buffer (Catmull 1974; Straßer 1974) over (depth, id): each triangle's box is walked, centres inside
/// all three edge functions (Pineda 1988) are fragments, and the nearer of fragment and buffer stays.
/// Triangles may come in any order. A triangle that snapping turned over is drawn too, so that no hole opens
/// beside it.
/// @pre target.buffer has target.rect's size, unless there are target.lists
RasterCounts rasterize_zbuffer(std::span<const ScreenTriangle> triangles, const RasterTarget& target);

}  // namespace velum
