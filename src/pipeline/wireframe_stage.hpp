#pragma once

#include <cstdint>
#include <vector>

#include "../visibility/sample_positions.hpp"
#include "stages.hpp"

namespace velum {

/// What the wireframe keeps between frames.
struct WireframeBuffers {
  ClipVertices vertices;
  std::vector<glm::uvec2> edges;
  std::vector<ScreenTriangle> screen_triangles;
  VisibilityBuffer nearest;              ///< the nearest edge at each pixel; its ids mean nothing
  SamplePosition sample = pixel_centre;  ///< where in the pixels the edges are drawn

  void draw_edges(const Scene& scene, std::uint32_t instance, const glm::dmat4& clip_from_object,
                  const RenderSettings& settings, const Rect& rect);
};

/// Draws the edges of all triangles that are not culled, as segments, into buffers.nearest: each edge of a
/// mesh once, in the direction of rising vertex indices. Nothing is counted.
void draw_wireframe(const Scene& scene, const ViewingTransform& viewing, const RenderSettings& settings,
                    const Rect& rect, WireframeBuffers& buffers);

/// Whether an edge shows on a surface: whether it is not farther than the surface's plane at the place on the
/// edge that the pixel stands for. That place lies across the edge from the pixel's centre, up to half a line
/// width away (and 1/256 pixel for the snapping at either end), so the surface's depth there differs from
/// that at the centre by at most its slope times that distance; a few float32 roundings come on top. An edge
/// of the surface itself therefore always shows, and so does one that lies on it.
/// @param surface  depth of the visible surface
/// @param edge_r   reversed depth of the nearest edge at pixel (x, y)
bool is_edge_seen(const DepthPlane& surface, float edge_r, int x, int y, float line_width);

}  // namespace velum
