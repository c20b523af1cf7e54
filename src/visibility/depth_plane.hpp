#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>

#include "../projection/viewport.hpp"

namespace velum {

/// The reversed depth r = 1 - z of a triangle as a function of the pixel, in float32, in one written-down
/// order:
///
///   r = (r_ref + dx·(x - x_ref)) + dy·(y - y_ref), clamped to [lower, upper].
///
/// Every visibility method evaluates exactly this, so equal ids mean equal depth bits. The value is never
/// NaN, never negative and never -0, so its bits compare as integers; it is monotone in x and in y, so bounds
/// over a block of pixels stand at its corners.
struct DepthPlane {
  float r_ref = 0.0f;
  float dx = 0.0f;  ///< per pixel to the right
  float dy = 0.0f;  ///< per pixel downwards
  std::int32_t x_ref = 0;
  std::int32_t y_ref = 0;
  float lower = 0.0f;
  float upper = 0.0f;

  /// @param x, y  pixel of the whole picture (not of a crop)
  float at(int x, int y) const {
    const float r = (r_ref + dx * static_cast<float>(x - x_ref)) + dy * static_cast<float>(y - y_ref);
    return r < lower ? lower : (r > upper ? upper : r);
  }
};

/// The plane through the *unclipped, unsnapped* homogeneous triangle (Olano & Greer 1997, "Triangle Scan
/// Conversion using 2D Homogeneous Coordinates"), set up in double and rounded once, so that all pieces of a
/// clipped triangle share it and w ≤ 0 needs no clipping.
///
/// The reference pixel is the one nearest to the farthest vertex with w > 0: there r is smallest and float32
/// finest, so distant surfaces keep the resolution that reversed depth gives them. Seen exactly edge-on
/// (determinant 0, or a slope that float32 cannot hold), the depth is that of the nearest vertex everywhere.
///
/// @param triangle     clip space, finite, at least one w > 0
/// @param determinant  homogeneous_determinant of the triangle
DepthPlane depth_plane(const std::array<glm::dvec4, 3>& triangle, double determinant,
                       const Viewport& viewport);

}  // namespace velum
