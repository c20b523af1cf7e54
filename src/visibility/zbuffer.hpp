#pragma once

#include <cstdint>
#include <span>

#include "../base/rect.hpp"
#include "../image/visibility_buffer.hpp"
#include "screen_triangle.hpp"

namespace velum {

/// What one call of the raster did.
struct RasterCounts {
  std::uint64_t zero_area = 0;          ///< triangles without area on the pixel grid
  std::uint64_t pixels_tested = 0;      ///< centres tested against the edge functions
  std::uint64_t fragments = 0;          ///< centres covered
  std::uint64_t fragments_written = 0;  ///< fragments nearer than what stood in the buffer
};

/// The z-buffer (Catmull 1974; Straßer 1974) over (depth, id): each triangle's box is walked, centres inside
/// all three edge functions (Pineda 1988) are fragments, and the nearer of fragment and buffer stays.
/// Triangles may come in any order. A triangle that snapping turned over is drawn too, so that no hole opens
/// beside it.
///
/// @param rect  the part of the picture that the buffer holds: buffer pixel (0,0) is picture pixel (left,
/// top)
/// @pre buffer has rect's size
RasterCounts rasterize_zbuffer(std::span<const ScreenTriangle> triangles, const Rect& rect,
                               VisibilityBuffer& buffer);

}  // namespace velum
