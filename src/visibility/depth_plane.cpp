#include "depth_plane.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../base/elementary.hpp"

namespace velum {
namespace {

glm::dvec3 xyw(const glm::dvec4& v) {
  return {v.x, v.y, v.w};
}

double reversed_depth(const glm::dvec4& v) {
  return (v.w - v.z) / v.w;
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
  return (glm::cross(d1, d2) * r0 + glm::cross(d2, p0) * r1 + glm::cross(p0, d1) * r2) / determinant;
}

struct VertexRange {
  double nearest = 0.0;
  double farthest = 1.0;
  int farthest_vertex = -1;
  bool all_in_front = true;  ///< every w > 0
};

/// The smallest and largest reversed depth among the vertices with w > 0.
VertexRange vertex_range(const std::array<glm::dvec4, 3>& v) {
  VertexRange range;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec4& vertex = v[static_cast<std::size_t>(i)];
    if (!(vertex.w > 0.0)) {
      range.all_in_front = false;
      continue;
    }
    const double r = reversed_depth(vertex);
    if (range.farthest_vertex < 0 || r < range.farthest) {
      range.farthest = r;
      range.farthest_vertex = i;
    }
    if (i == 0 || r > range.nearest) range.nearest = r;
  }
  return range;
}

/// The pixel column (row) of a coordinate, kept inside the picture.
std::int32_t pixel_of(double coordinate, int size) {
  return static_cast<std::int32_t>(elementary::floor(std::clamp(coordinate, 0.0, size - 1.0)));
}

float unit_float(double r) {
  return static_cast<float>(r > 0.0 ? (r < 1.0 ? r : 1.0) : 0.0);
}

/// Slopes beyond this would let a product overflow; such a triangle is seen edge-on for all purposes.
constexpr double steepest = 1e30;

bool is_steep(double slope) {
  return !(slope <= steepest && slope >= -steepest);
}

}  // namespace

DepthPlane depth_plane(const std::array<glm::dvec4, 3>& triangle, double determinant,
                       const Viewport& viewport) {
  const VertexRange range = vertex_range(triangle);
  DepthPlane plane;
  plane.lower = range.all_in_front ? unit_float(range.farthest) : 0.0f;
  plane.upper = range.all_in_front ? unit_float(range.nearest) : 1.0f;

  const glm::dvec3 ndc = plane_in_ndc(triangle, determinant);
  const double dx = ndc.x * 2.0 / viewport.width;
  const double dy = -ndc.y * 2.0 / viewport.height;
  if (determinant == 0.0 || is_steep(dx) || is_steep(dy) || is_steep(ndc.z)) {
    plane.lower = plane.upper;
    plane.r_ref = plane.upper;
    return plane;
  }

  const glm::dvec4& farthest = triangle[static_cast<std::size_t>(std::max(range.farthest_vertex, 0))];
  const glm::dvec2 at = viewport.pixel_from_ndc(farthest.x / farthest.w, farthest.y / farthest.w);
  plane.x_ref = pixel_of(at.x, viewport.width);
  plane.y_ref = pixel_of(at.y, viewport.height);
  const glm::dvec2 centre = viewport.ndc_from_pixel(plane.x_ref + 0.5, plane.y_ref + 0.5);
  // + 0 makes -0 (a triangle in the far plane may have it) +0; no later sum gives -0 then.
  plane.r_ref = static_cast<float>(ndc.x * centre.x + ndc.y * centre.y + ndc.z) + 0.0f;
  plane.dx = static_cast<float>(dx);
  plane.dy = static_cast<float>(dy);
  return plane;
}

}  // namespace velum
