#include "shade.hpp"

#include "interpolate.hpp"

namespace velum {
namespace {

/// Lit at the centroid, where the vertex colours have their mean.
glm::vec4 lit_face(const Lighting& lighting, const TriangleView& t) {
  const glm::dvec3 centroid = (t.world[0] + t.world[1] + t.world[2]) / 3.0;
  const glm::vec4 base = (t.colours[0] + t.colours[1] + t.colours[2]) / 3.0f;
  return blinn_phong(lighting, *t.material, centroid, t.geometric_normal, to_viewer_from(centroid, t.eye),
                     base);
}

}  // namespace

LitTriangle light_triangle(Shading shading, const Lighting& lighting, const TriangleView& triangle) {
  LitTriangle lit{};
  if (shading == Shading::flat) lit.face = lit_face(lighting, triangle);
  if (shading == Shading::gouraud) {
    for (std::size_t i = 0; i < 3; ++i) {
      lit.corners[i] = blinn_phong(lighting, *triangle.material, triangle.world[i], triangle.normals[i],
                                   to_viewer_from(triangle.world[i], triangle.eye), triangle.colours[i]);
    }
  }
  return lit;
}

glm::vec4 shade(Shading shading, const Lighting& lighting, const LitTriangle& lit, const SurfacePoint& point,
                const MetricRange& range) {
  const glm::vec3& b = point.barycentric;
  switch (shading) {
    case Shading::flat:
      return lit.face;
    case Shading::gouraud:
      return interpolate(lit.corners, b);
    case Shading::phong:
      return blinn_phong(lighting, *point.material, point.position, point.shading_normal, point.to_viewer,
                         point.colour);
    case Shading::normal:
      return normal_colour(point.shading_normal);
    case Shading::depth:
      return depth_colour(point.metric_depth, range);
    case Shading::object_id:
      return id_colour(point.object);
    case Shading::triangle_id:
      return id_colour(point.primitive);
    case Shading::barycentric:
      return colour_of_codes(b);
  }
  return {0.0f, 0.0f, 0.0f, 1.0f};
}

}  // namespace velum
