#pragma once

#include <array>
#include <glm/mat4x4.hpp>

#include "debug_colours.hpp"
#include "shading.hpp"
#include "triangle_view.hpp"

namespace velum {

/// One visible segment or point as one camera sees it: set up once, then evaluated at its pixels. A point has
/// its one vertex twice. Owns what it needs except the material, which must outlive it.
struct LineView {
  PrimitivePlace place;
  std::uint32_t primitive = 0;
  const Material* material = nullptr;
  glm::dvec4 eye{0.0, 0.0, 1.0, 0.0};  ///< of the viewer
  bool x_major = true;                 ///< along which axis pixels are counted; see is_x_major()
  std::array<glm::dvec2, 2> along;     ///< (s·w, w), s the pixel coordinate on that axis
  std::array<glm::dvec3, 2> world;
  std::array<double, 2> metric_depth;            ///< world units
  std::array<glm::vec3, 2> normals;              ///< world space, unit length; 0 where there is none
  std::array<glm::vec4, 2> colours;              ///< vertex colour · base colour, linear, straight alpha
  std::array<glm::vec2, 2> texture_coordinates;  ///< 0 where the mesh has none
};

/// Sets a segment or point up for attribute evaluation.
/// @pre place exists in the scene and is no triangle; its clip-space vertices are finite
/// @param clip_from_object  ViewingTransform::clip_from_object() of the place's instance
/// @param x_major           as the raster counted its pixels; of a point it does not matter
LineView view_line(const Scene& scene, const PrimitivePlace& place, const glm::dmat4& clip_from_object,
                   const Viewer& viewer, bool x_major);

/// The perspective-correct parameter where the segment passes the centre of column (row) x (y), 0…1 from its
/// first end to its second; exactly 0 or 1 beyond an end, and 0 on a point.
double parameter_at(const LineView& line, int x, int y);
/// The same in the column (row) of another position: pixels, y down, centres at +0.5.
double parameter_at(const LineView& line, const glm::dvec2& at);

/// Everything a shader may want to know of the segment or point at pixel (x, y) of the whole picture: the
/// place on the segment in the same column (row), so all pixels across a wide line are alike.
/// @param reversed_depth  as the visibility buffer has it
SurfacePoint surface_point(const LineView& line, int x, int y, float reversed_depth);
/// The same elsewhere in the pixel. @param at  pixels, y down, centres at +0.5
SurfacePoint surface_point(const LineView& line, const glm::dvec2& at, int x, int y, float reversed_depth);

/// The colour of a point of a segment or point, linear with straight alpha. The lit shadings all light it at
/// every pixel with its shading normal; without one it shows its own colour, unlit.
/// @param range  the visible metric depths; used by Shading::depth only
glm::vec4 shade_line(Shading shading, const Lighting& lighting, const SurfacePoint& point,
                     const MetricRange& range);

}  // namespace velum
