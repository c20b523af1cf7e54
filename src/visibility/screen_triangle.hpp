#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>

#include "../projection/viewport.hpp"
#include "depth_plane.hpp"

namespace velum {

/// Positions on the picture are whole multiples of 1/256 pixel; from here on coverage is decided in integers.
inline constexpr int subpixel_bits = 8;
inline constexpr std::int32_t subpixels = 1 << subpixel_bits;

/// A vertex on the picture, in 1/256 pixel, y down.
struct SnappedVertex {
  std::int32_t x = 0;
  std::int32_t y = 0;
  bool operator==(const SnappedVertex&) const = default;
};

/// A triangle (or a piece of a clipped one) ready for the raster.
struct ScreenTriangle {
  std::array<SnappedVertex, 3> vertices;
  DepthPlane depth;
  std::uint32_t primitive = 0;
};

/// Perspective divide, viewport mapping and snapping, half up. @pre needs_no_cut(vertex) for the volume of
/// a clip policy (clipping/clip_volume.hpp), so that the result is within ±2²³
SnappedVertex snap(const glm::dvec4& vertex, const Viewport& viewport);

/// Twice the signed area in (1/256 pixel)², y down: positive if the vertices run clockwise as seen on the
/// picture.
constexpr std::int64_t doubled_area(const std::array<SnappedVertex, 3>& v) {
  return static_cast<std::int64_t>(v[1].x - v[0].x) * (v[2].y - v[0].y) -
         static_cast<std::int64_t>(v[1].y - v[0].y) * (v[2].x - v[0].x);
}

/// One edge a → b as an exact integer function: positive to the right of the edge as seen on the picture (y
/// down), which is the inside if the triangle runs clockwise there.
///
/// The top-left rule is folded in: `value` is one less for edges that do not own their points, so a centre is
/// covered exactly if all three values are ≥ 0.
struct EdgeFunction {
  std::int64_t value = 0;   ///< at the pixel centre it was made for
  std::int64_t step_x = 0;  ///< added per pixel to the right
  std::int64_t step_y = 0;  ///< added per pixel downwards

  /// @param x, y  the pixel at whose centre `value` stands
  static constexpr EdgeFunction between(const SnappedVertex& a, const SnappedVertex& b, int x, int y) {
    const std::int64_t dx = b.x - a.x;
    const std::int64_t dy = b.y - a.y;
    const std::int64_t px = static_cast<std::int64_t>(x) * subpixels + subpixels / 2;
    const std::int64_t py = static_cast<std::int64_t>(y) * subpixels + subpixels / 2;
    const bool is_left = dy < 0;
    const bool is_top = dy == 0 && dx > 0;
    return {dx * (py - a.y) - dy * (px - a.x) - (is_left || is_top ? 0 : 1), -dy * subpixels, dx * subpixels};
  }
};

}  // namespace velum
