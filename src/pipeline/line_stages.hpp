#pragma once

/// The stages of segments and points, beside those of triangles in stages.hpp. The raster sees both as
/// screen triangles, so every visibility method draws them alike.

#include <cstdint>
#include <vector>

#include "stages.hpp"

namespace velum {

/// Clips a segment (clip_segment), divides and snaps its ends, and appends its pieces to `out`.
/// @param width  pixels
void set_up_segment(const ClipVertices& vertices, const glm::uvec2& indices, std::uint32_t primitive,
                    float width, const Viewport& viewport, Counters& counters,
                    std::vector<ScreenTriangle>& out);

/// Whether the raster counts a segment's columns (else its rows); decided by the piece that is drawn. True
/// for a point. @pre the place exists and is no triangle; some of it is inside the view volume
bool is_x_major(const Scene& scene, const PrimitivePlace& place, const glm::dmat4& clip_from_object,
                const Viewport& viewport);

/// Appends a point if its centre is inside the view volume; the square around it is not clipped.
/// @param size  pixels
void set_up_point(const ClipVertices& vertices, std::uint32_t index, std::uint32_t primitive, float size,
                  const Viewport& viewport, Counters& counters, std::vector<ScreenTriangle>& out);

}  // namespace velum
