#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "../scene/material.hpp"
#include "../scene/primitive_place.hpp"

namespace velum {

/// Everything a shader may want to know of the surface seen at one pixel. World space unless said otherwise.
/// Under RenderSettings::samples, where the surface covers a part of the pixel's samples, it is evaluated at
/// the centroid of those at which it is seen, not at the pixel's centre.
struct SurfacePoint {
  glm::dvec3 position{0.0};             ///< on the primitive, at the pixel's centre
  glm::dvec3 to_viewer{0.0, 0.0, 1.0};  ///< unit length
  glm::vec3 geometric_normal{0.0f};     ///< of the triangle, unit length, on the viewer's side; 0 of others
  glm::vec3 shading_normal{0.0f};       ///< interpolated, unit length, turned to the viewer's side with the
                                        ///< geometric one; 0 for a segment or point without normals
  glm::vec3 barycentric{0.0f};          ///< perspective-correct, ≥ 0, sum 1; (1-t, t, 0) on a segment
  glm::vec4 colour{1.0f};               ///< linear, straight alpha: vertex colour · base colour · texel
  glm::vec4 texel{1.0f};  ///< the material's texture under the pixel, linear, straight alpha; none: 1
  glm::vec2 texture_coordinate{0.0f};  ///< the mesh's
  glm::dvec2 texture_dx{0.0};          ///< its change per pixel to the right, exact at the pixel's centre
  glm::dvec2 texture_dy{0.0};          ///< its change per pixel down
  double metric_depth = 0.0;           ///< distance from the camera plane along the look vector, world units
  float depth = 1.0f;                  ///< canonical, 0 near … 1 far
  std::uint32_t object = 0;            ///< instance
  PrimitiveKind kind = PrimitiveKind::triangle;
  std::uint32_t index = 0;      ///< among the triangles, segments or points of the instance's mesh
  std::uint32_t primitive = 0;  ///< in the scene
  bool back_facing = false;
  int x = 0;  ///< pixel
  int y = 0;
  const Material* material = nullptr;
};

/// Custom shading: a colour for a surface point, linear with straight alpha.
using Shader = std::function<glm::vec4(const SurfacePoint&)>;

}  // namespace velum
