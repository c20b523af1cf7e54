#pragma once

/// The newcomer's map: the stages of the viewing pipeline in flow order. Each is a free function from plain
/// data to plain data; no step looks back. render.cpp calls them one after the other:
///
/// - transform_vertices: object space → clip space, and each vertex's 6-bit outcode
/// - assemble: one triangle: finite? which way does it face? trivially accepted, rejected, or to be cut?
/// - clip_triangle (clipping/): the part between near and far and inside the guard band or the view volume
/// - set_up: divide, viewport, snapping; the depth plane of the whole triangle; a fan of screen triangles
/// - rasterize (visibility/): coverage and depth → VisibilityBuffer, by the method of the settings
/// - or cast_visibility (raycast/): one ray per pixel into the scene, past all the stages above
/// - ShadeStage (shading/): each visible pixel once → Picture; translucent ones let the next layer through
///
/// All spaces are named target_from_source.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "../base/counters.hpp"
#include "../base/rect.hpp"
#include "../clipping/clip_polygon.hpp"
#include "../image/visibility_buffer.hpp"
#include "../projection/camera.hpp"
#include "../projection/facing.hpp"
#include "../projection/viewport.hpp"
#include "../scene/scene.hpp"
#include "../visibility/raster_target.hpp"
#include "../visibility/scanline.hpp"
#include "../visibility/screen_triangle.hpp"
#include "picture.hpp"
#include "settings.hpp"

namespace velum {

/// A mesh's vertices in clip space, one entry per vertex.
struct ClipVertices {
  std::vector<glm::dvec4> positions;
  std::vector<Outcode> outcodes;
};

/// One vertex, in double and one written-down order: clip = ((m0·x + m1·y) + m2·z) + m3.
inline glm::dvec4 clip_position(const glm::dmat4& clip_from_object, const glm::vec3& position) {
  const glm::dvec3 p(position);
  return ((clip_from_object[0] * p.x + clip_from_object[1] * p.y) + clip_from_object[2] * p.z) +
         clip_from_object[3];
}

/// Transforms every vertex once, see clip_position().
/// @param out  overwritten; its memory is kept
void transform_vertices(std::span<const glm::vec3> positions, const glm::dmat4& clip_from_object,
                        ClipVertices& out);

/// What becomes of a triangle before the raster.
enum class TriangleFate { not_finite, culled, rejected, accepted, to_clip };

/// A triangle of the scene in clip space.
struct AssembledTriangle {
  std::array<glm::dvec4, 3> vertices;
  Outcode all_outside = 0;  ///< AND of the outcodes: those of the view volume, whatever it is clipped against
  Outcode some_outside = 0;  ///< OR of the outcodes
  double determinant = 0.0;  ///< homogeneous_determinant: > 0 counter-clockwise in the picture
  Facing facing = Facing::front;
  ClipVolume volume{};  ///< what it is clipped against
  TriangleFate fate = TriangleFate::accepted;
};

/// What the settings have triangles clipped against.
inline ClipVolume clip_volume_of(const RenderSettings& settings) {
  return clip_volume(settings.clip, settings.width, settings.height);
}

/// Fetches a triangle and decides its fate; counts it.
AssembledTriangle assemble(const ClipVertices& vertices, const glm::uvec3& indices, bool mirrored, Cull cull,
                           const ClipVolume& volume, Counters& counters);

/// The same for a triangle whose vertices are at hand.
AssembledTriangle assemble(const std::array<glm::dvec4, 3>& vertices, bool mirrored, Cull cull,
                           const ClipVolume& volume, Counters& counters);

/// Appends the triangle's pieces (one, or a fan where it was cut) to `out`.
void set_up(const AssembledTriangle& triangle, std::uint32_t primitive, const Viewport& viewport,
            Counters& counters, std::vector<ScreenTriangle>& out);

/// Coverage and depth by the method of the settings, whichever that is.
RasterCounts rasterize(std::span<const ScreenTriangle> triangles, const RasterTarget& target,
                       const RenderSettings& settings, ScanlineTables& tables);

}  // namespace velum
