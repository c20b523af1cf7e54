#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "debug_colours.hpp"
#include "shading.hpp"
#include "surface_point.hpp"
#include "triangle_view.hpp"

namespace velum {

/// What a shading has to know of a triangle beyond its TriangleView; computed once per triangle.
struct LitTriangle {
  glm::vec4 face{0.0f};              ///< flat: lit at the centroid with the geometric normal
  std::array<glm::vec4, 3> corners;  ///< gouraud: lit at the vertices
  glm::vec3 face_highlight{0.0f};    ///< the part of `face` that no texture colours; 0 without a texture
  std::array<glm::vec3, 3> corner_highlights{};  ///< the same of `corners`
};

/// Lights a triangle's centroid (flat) or vertices (gouraud); does nothing for the other shadings.
LitTriangle light_triangle(Shading shading, const Lighting& lighting, const TriangleView& triangle);

/// The colour of a surface point, linear with straight alpha. Lit shadings keep the surface's alpha; debug
/// views are not lit and opaque.
/// @param lit    light_triangle() of the point's triangle
/// @param range  the visible metric depths; used by Shading::depth only
glm::vec4 shade(Shading shading, const Lighting& lighting, const LitTriangle& lit, const SurfacePoint& point,
                const MetricRange& range);

}  // namespace velum
