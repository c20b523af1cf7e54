#pragma once

#include <glm/vec4.hpp>

namespace velum {

/// Draws a triangle's edge over a pixel: a line one pixel wide and centred on the edge, softened over one
/// pixel (box filter), so that two triangles draw half of their common edge each. Black on light surfaces,
/// white on dark ones.
/// @param colour         what is there, linear, straight alpha
/// @param edge_distance  in pixels from the pixel's centre to the nearest edge, ≥ 0, see edge_distance()
/// @return linear, straight alpha
glm::vec4 over_wireframe(const glm::vec4& colour, float edge_distance);

}  // namespace velum
