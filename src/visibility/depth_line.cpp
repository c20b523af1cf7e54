#include "depth_line.hpp"

#include <tuple>
#include <utility>

#include "depth_range.hpp"

namespace velum {
namespace {

/// The ends in an order that does not depend on the one given.
std::array<glm::dvec4, 2> ordered(const std::array<glm::dvec4, 2>& s) {
  const auto key = [](const glm::dvec4& v) { return std::tie(v.x, v.y, v.z, v.w); };
  return key(s[1]) < key(s[0]) ? std::array<glm::dvec4, 2>{s[1], s[0]} : s;
}

/// The change of r per unit of canonical x (y): r·w is linear along the segment, so r = A·s + C with
/// A·sᵢ + C·wᵢ = wᵢ - zᵢ at both ends. In differences to the first end, which lose fewer digits.
double slope_in_ndc(const std::array<glm::dvec4, 2>& ends, int axis) {
  const double s = ends[0][axis], w = ends[0].w, r = ends[0].w - ends[0].z;
  const double ds = ends[1][axis] - s, dw = ends[1].w - w, dr = (ends[1].w - ends[1].z) - r;
  return (r * dw - dr * w) / (s * dw - ds * w);
}

}  // namespace

DepthPlane depth_line(const std::array<glm::dvec4, 2>& segment, bool x_major, const Viewport& viewport) {
  const std::array<glm::dvec4, 2> ends = ordered(segment);
  const VertexRange range = vertex_range(ends);
  DepthPlane plane;
  plane.lower = range.all_in_front ? unit_float(range.farthest) : 0.0f;
  plane.upper = range.all_in_front ? unit_float(range.nearest) : 1.0f;

  const double slope = slope_in_ndc(ends, x_major ? 0 : 1);
  const double per_pixel = x_major ? slope * 2.0 / viewport.width : -slope * 2.0 / viewport.height;
  if (is_steep(slope) || is_steep(per_pixel)) {
    plane.r_ref = plane.lower = plane.upper;
    return plane;
  }
  const glm::dvec4& farthest = ends[range.farthest_vertex == 1 ? 1 : 0];
  const glm::dvec2 at = viewport.pixel_from_ndc(farthest.x / farthest.w, farthest.y / farthest.w);
  const int size = x_major ? viewport.width : viewport.height;
  const double along = x_major ? at.x : at.y;
  const std::int32_t pixel = pixel_of(along, size);
  (x_major ? plane.x_ref : plane.y_ref) = pixel;
  (x_major ? plane.dx : plane.dy) = static_cast<float>(per_pixel);
  // + 0 makes -0 +0, as in depth_plane().
  plane.r_ref = static_cast<float>(range.farthest + per_pixel * (pixel + 0.5 - along)) + 0.0f;
  return plane;
}

DepthPlane depth_of_point(const glm::dvec4& point) {
  DepthPlane plane;
  plane.r_ref = plane.lower = plane.upper = unit_float(reversed_depth(point));
  return plane;
}

}  // namespace velum
