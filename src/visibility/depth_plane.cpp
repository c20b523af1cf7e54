#include "depth_plane.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "depth_range.hpp"

namespace velum {
namespace {

glm::dvec3 xyw(const glm::dvec4& v) {
  return {v.x, v.y, v.w};
}

/// r in canonical coordinates: r = dot(result, (x, y, 1)). Rows v0, v1 - v0, v2 - v0 have the determinant of
/// v0, v1, v2 but lose fewer digits for small triangles.
glm::dvec3 plane_in_ndc(const std::array<glm::dvec4, 3>& v, double determinant) {
  const glm::dvec3 p0 = xyw(v[0]);
  const glm::dvec3 d1 = xyw(v[1]) - p0;
  const glm::dvec3 d2 = xyw(v[2]) - p0;
  const double r0 = v[0].w - v[0].z;
  const double r1 = (v[1].w - v[1].z) - r0;
  const double r2 = (v[2].w - v[2].z) - r0;
  // A determinant so small that its reciprocal may overflow is scaled, which is exact.
  const double scale = std::fabs(determinant) < 0x1p-960 ? 0x1p+300 : 1.0;
  const glm::dvec3 sum = glm::cross(d1, d2) * r0 + glm::cross(d2, p0) * r1 + glm::cross(p0, d1) * r2;
  return sum * scale * (1.0 / (determinant * scale));
}

}  // namespace

DepthPlane depth_plane(const std::array<glm::dvec4, 3>& triangle, double determinant,
                       const Viewport& viewport) {
  const VertexRange range = vertex_range(triangle);
  DepthPlane plane;
  plane.lower = range.all_in_front ? unit_float(range.farthest) : 0.0f;
  plane.upper = range.all_in_front ? unit_float(range.nearest) : 1.0f;

  const glm::dvec3 ndc = plane_in_ndc(triangle, determinant);
  const double ndc_per_column = 2.0 / viewport.width;
  const double ndc_per_row = 2.0 / viewport.height;
  const double dx = ndc.x * ndc_per_column;
  const double dy = -ndc.y * ndc_per_row;
  if (determinant == 0.0 || is_steep(dx) || is_steep(dy) || is_steep(ndc.z)) {
    plane.lower = plane.upper;
    plane.r_ref = plane.upper;
    return plane;
  }

  const glm::dvec4& farthest = triangle[static_cast<std::size_t>(std::max(range.farthest_vertex, 0))];
  const double inverse_w = 1.0 / farthest.w;
  const glm::dvec2 at = viewport.pixel_from_ndc(farthest.x * inverse_w, farthest.y * inverse_w);
  plane.x_ref = pixel_of(at.x, viewport.width);
  plane.y_ref = pixel_of(at.y, viewport.height);
  const double x = (plane.x_ref + 0.5) * ndc_per_column - 1.0;
  const double y = 1.0 - (plane.y_ref + 0.5) * ndc_per_row;
  // + 0 makes -0 (a triangle in the far plane may have it) +0; no later sum gives -0 then.
  plane.r_ref = static_cast<float>(ndc.x * x + ndc.y * y + ndc.z) + 0.0f;
  plane.dx = static_cast<float>(dx);
  plane.dy = static_cast<float>(dy);
  return plane;
}

}  // namespace velum
