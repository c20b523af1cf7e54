#include "shade.hpp"

#include "interpolate.hpp"

namespace velum {
namespace {

glm::vec4 lit_at(const Lighting& lighting, const TriangleView& t, const glm::dvec3& position,
                 const glm::vec3& normal, const glm::vec4& base) {
  return blinn_phong(lighting, *t.material, position, normal, to_viewer_from(position, t.eye), base);
}

/// What a black surface would reflect.
glm::vec3 highlight_at(const Lighting& lighting, const TriangleView& t, const glm::dvec3& position,
                       const glm::vec3& normal) {
  if (!t.material->texture) return glm::vec3(0.0f);
  return glm::vec3(lit_at(lighting, t, position, normal, glm::vec4(0.0f)));
}

/// Lit at the centroid, where the vertex colours have their mean.
void light_face(const Lighting& lighting, const TriangleView& t, LitTriangle& lit) {
  const glm::dvec3 centroid = (t.world[0] + t.world[1] + t.world[2]) / 3.0;
  const glm::vec4 base = (t.colours[0] + t.colours[1] + t.colours[2]) / 3.0f;
  lit.face = lit_at(lighting, t, centroid, t.geometric_normal, base);
  lit.face_highlight = highlight_at(lighting, t, centroid, t.geometric_normal);
}

void light_corners(const Lighting& lighting, const TriangleView& t, LitTriangle& lit) {
  for (std::size_t i = 0; i < 3; ++i) {
    lit.corners[i] = lit_at(lighting, t, t.world[i], t.normals[i], t.colours[i]);
    lit.corner_highlights[i] = highlight_at(lighting, t, t.world[i], t.normals[i]);
  }
}

/// The texel colours what the surface scatters, not its highlight: as if it had been part of the base colour.
glm::vec4 textured(const glm::vec4& lit, const glm::vec3& highlight, const SurfacePoint& point) {
  if (!point.material->texture) return lit;
  return {highlight + (glm::vec3(lit) - highlight) * glm::vec3(point.texel), lit.a * point.texel.a};
}

}  // namespace

LitTriangle light_triangle(Shading shading, const Lighting& lighting, const TriangleView& triangle) {
  LitTriangle lit{};
  if (shading == Shading::flat) light_face(lighting, triangle, lit);
  if (shading == Shading::gouraud) light_corners(lighting, triangle, lit);
  return lit;
}

glm::vec4 shade(Shading shading, const Lighting& lighting, const LitTriangle& lit, const SurfacePoint& point,
                const MetricRange& range) {
  const glm::vec3& b = point.barycentric;
  switch (shading) {
    case Shading::flat:
      return textured(lit.face, lit.face_highlight, point);
    case Shading::gouraud:
      return textured(interpolate(lit.corners, b), interpolate(lit.corner_highlights, b), point);
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
