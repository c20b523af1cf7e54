#pragma once

#include <cstdint>
#include <vector>

#include "../base/executor.hpp"
#include "../visibility/sample_positions.hpp"
#include "stages.hpp"

namespace velum {

/// What the wireframe keeps between frames.
struct WireframeBuffers {
  /// What a run of a mesh's triangles has: each of its edges once, and their screen triangles.
  struct Run {
    std::vector<glm::uvec2> edges;
    std::vector<ScreenTriangle> screen_triangles;
  };

  ClipVertices vertices;                ///< of one instance
  std::vector<Run> runs;                ///< of one instance's round
  std::vector<ScreenTriangle> waiting;  ///< to be drawn
  std::vector<VisibilityBuffer> bands;  ///< rows of the picture, one for each worker
  VisibilityBuffer nearest;             ///< the nearest edge at each pixel; its ids mean nothing
};

/// What drawing needs to know of the frame.
struct WireframeInput {
  const Scene& scene;
  const ViewingTransform& viewing;
  const RenderSettings& settings;
  Rect rect;
  Executor& executor;
  SamplePosition sample = pixel_centre;  ///< where in the pixels the edges are drawn
};

/// Draws the edges of all triangles that are not culled, as segments, into buffers.nearest: in the direction
/// of rising vertex indices, so that an edge is the same line from all its triangles. Nothing is counted.
/// Runs of triangles are set up, and bands of the picture drawn, on all threads; the nearest edge is the same
/// in any order.
void draw_wireframe(const WireframeInput& input, WireframeBuffers& buffers);

/// Whether an edge shows on a surface: whether it is not farther than the surface's plane at the place on the
/// edge that the pixel stands for. That place lies across the edge from the pixel's centre, up to half a line
/// width away (and 1/256 pixel for the snapping at either end), so the surface's depth there differs from
/// that at the centre by at most its slope times that distance; a few float32 roundings come on top. An edge
/// of the surface itself therefore always shows, and so does one that lies on it.
/// @param surface  depth of the visible surface
/// @param edge_r   reversed depth of the nearest edge at pixel (x, y)
bool is_edge_seen(const DepthPlane& surface, float edge_r, int x, int y, float line_width);

}  // namespace velum
