#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "../scene/scene.hpp"
#include "stages.hpp"

namespace velum {

/// Where a clip-space point with w > 0 comes to lie: the last steps before coverage is decided.
struct PlacedPoint {
  glm::dvec4 clip{0.0};     ///< homogeneous
  glm::dvec3 ndc{0.0};      ///< canonical: clip divided by w
  glm::dvec2 pixel{0.0};    ///< pixels, y down, not yet snapped
  bool is_snapped = false;  ///< nothing needs to be cut off first
  SnappedVertex snapped;    ///< 1/256 pixel; meaningful only where is_snapped
};

/// A vertex's way through the stages.
struct VertexTrace {
  std::uint32_t index = 0;         ///< in the mesh
  glm::dvec3 object{0.0};          ///< as the mesh has it
  std::vector<glm::dvec4> images;  ///< world space, then after each of the viewing transform's stages
  glm::dvec4 clip{0.0};            ///< by the product of all matrices, as the pipeline has it
  Outcode code = 0;

  /// w > 0: the vertex has a place on the picture plane.
  bool is_in_front() const { return clip.w > 0.0; }
};

/// Everything that happened to one triangle on its way to the raster, told by the pipeline's own functions.
struct TriangleTrace {
  std::uint32_t primitive = 0;
  PrimitivePlace place;
  std::array<VertexTrace, 3> vertices;
  bool mirrored = false;        ///< the instance's matrix turns orientations
  AssembledTriangle assembled;  ///< determinant, facing, outcodes, fate
  Outcode cut_by = 0;           ///< planes that cut something off
  /// The corners of what the raster gets: the triangle itself, what clipping left of it, or nothing.
  std::vector<PlacedPoint> polygon;
  std::vector<ScreenTriangle> pieces;  ///< a fan over the polygon
};

/// Follows one triangle through every stage.
/// @param settings  size, culling and clip policy count; a crop does not
/// @pre primitive < scene.primitive_count()
/// @throws Error (usage) for the id of a segment or point, and as render() for sizes and cameras that cannot
/// be used
TriangleTrace trace_triangle(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                             std::uint32_t primitive);

/// Divide, viewport mapping and snapping. @pre clip.w > 0
/// @param volume  what triangles are clipped against
PlacedPoint place_on_picture(const glm::dvec4& clip, const Viewport& viewport, const ClipVolume& volume = {});

}  // namespace velum
