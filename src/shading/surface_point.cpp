#include "surface_point.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "interpolate.hpp"
#include "triangle_view.hpp"

namespace velum {
namespace {

/// From the primitive's plane, where the pixel's centre meets it, within the range of the vertices. A
/// triangle that reaches behind the viewer has no such range: there a centre beyond an edge takes the nearby
/// point's depth.
double metric_depth(const TriangleView& triangle, const Barycentrics& barycentrics) {
  const auto [lowest, highest] =
      std::minmax({triangle.metric_depth[0], triangle.metric_depth[1], triangle.metric_depth[2]});
  const double depth = interpolate(triangle.metric_depth, barycentrics.exact);
  if (triangle.is_in_front) return std::clamp(depth, lowest, highest);
  return depth >= lowest && depth <= highest ? depth
                                             : interpolate(triangle.metric_depth, barycentrics.clamped);
}

glm::vec3 shading_normal(const TriangleView& triangle, const glm::vec3& weights) {
  const glm::vec3 sum = interpolate(triangle.normals, weights);
  const float length = std::sqrt(glm::dot(sum, sum));
  return length > 0.0f ? sum / length : triangle.geometric_normal;
}

/// Looks the texture up in double: far out, a float coordinate is coarser than a texel.
void apply_texture(SurfacePoint& point, const TriangleView& triangle, const glm::dvec3& weights) {
  const Material& material = *triangle.material;
  if (material.texture == nullptr) return;
  glm::dvec2 at(0.0);
  for (std::size_t i = 0; i < 3; ++i)
    at += glm::dvec2(triangle.texture_coordinates[i]) * weights[static_cast<int>(i)];
  const TextureMapping& mapping = material.texture_mapping;
  const glm::dvec2 scale(mapping.scale);
  point.texel =
      filtered(*material.texture, mapping.wrap, triangle.texture_filter,
               {at * scale + glm::dvec2(mapping.offset), point.texture_dx * scale, point.texture_dy * scale});
  point.colour *= point.texel;
}

}  // namespace

SurfacePoint surface_point(const TriangleView& triangle, int x, int y, float reversed_depth) {
  return surface_point(triangle, {x + 0.5, y + 0.5}, x, y, reversed_depth);
}

SurfacePoint surface_point(const TriangleView& triangle, const glm::dvec2& at, int x, int y,
                           float reversed_depth) {
  const Barycentrics barycentrics = barycentrics_at(triangle, at.x, at.y);
  SurfacePoint point;
  point.position = interpolate(triangle.world, barycentrics.clamped);
  point.to_viewer = to_viewer_from(point.position, triangle.eye);
  point.barycentric = barycentrics.clamped;
  point.geometric_normal = triangle.geometric_normal;
  point.shading_normal = shading_normal(triangle, point.barycentric);
  point.colour = interpolate(triangle.colours, point.barycentric);
  point.texture_coordinate = interpolate(triangle.texture_coordinates, point.barycentric);
  const glm::dmat2 change = texture_derivatives_at(triangle, at.x, at.y);
  point.texture_dx = change[0];
  point.texture_dy = change[1];
  point.metric_depth = metric_depth(triangle, barycentrics);
  point.depth = 1.0f - reversed_depth;
  point.object = triangle.place.instance;
  point.index = triangle.place.index;
  point.primitive = triangle.primitive;
  point.back_facing = triangle.facing == Facing::back;
  point.x = x;
  point.y = y;
  point.material = triangle.material;
  apply_texture(point, triangle, barycentrics.clamped);
  return point;
}

}  // namespace velum
