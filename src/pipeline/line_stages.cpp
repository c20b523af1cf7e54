#include "line_stages.hpp"

#include "../clipping/clip_segment.hpp"
#include "../clipping/cut.hpp"
#include "../visibility/depth_line.hpp"
#include "../visibility/screen_segment.hpp"

namespace velum {

void set_up_segment(const ClipVertices& vertices, const glm::uvec2& indices, std::uint32_t primitive,
                    float width, const Viewport& viewport, Counters& counters,
                    std::vector<ScreenTriangle>& out) {
  const std::array<glm::dvec4, 2> ends{vertices.positions[indices.x], vertices.positions[indices.y]};
  ++counters.segments;
  if (!is_finite(ends[0]) || !is_finite(ends[1])) {
    ++counters.not_finite;
    return;
  }
  const ClippedSegment piece = clip_segment(ends[0], ends[1]);
  if (!piece.visible) {
    ++counters.segments_outside;
    return;
  }
  if (piece.plane0 >= 0 || piece.plane1 >= 0) ++counters.segments_clipped;
  const SnappedVertex a = snap(piece.a, viewport);
  const SnappedVertex b = snap(piece.b, viewport);
  ScreenTriangle prototype;
  prototype.primitive = primitive;
  prototype.depth = depth_line(ends, is_x_major(a, b), viewport);
  append_segment(a, b, width, prototype, out);
  counters.screen_triangles += 2;
}

bool is_x_major(const Scene& scene, const PrimitivePlace& place, const glm::dmat4& clip_from_object,
                const Viewport& viewport) {
  if (place.kind != PrimitiveKind::segment) return true;
  const Mesh& mesh = scene.meshes()[scene.instances()[place.instance].mesh];
  const glm::uvec2& ends = mesh.segments[place.index];
  const ClippedSegment piece = clip_segment(clip_position(clip_from_object, mesh.positions[ends.x]),
                                            clip_position(clip_from_object, mesh.positions[ends.y]));
  return is_x_major(snap(piece.a, viewport), snap(piece.b, viewport));
}

void set_up_point(const ClipVertices& vertices, std::uint32_t index, std::uint32_t primitive, float size,
                  const Viewport& viewport, Counters& counters, std::vector<ScreenTriangle>& out) {
  const glm::dvec4& point = vertices.positions[index];
  ++counters.points;
  if (!is_finite(point)) {
    ++counters.not_finite;
    return;
  }
  if (!clip_point(point)) {
    ++counters.points_outside;
    return;
  }
  ScreenTriangle prototype;
  prototype.primitive = primitive;
  prototype.depth = depth_of_point(point);
  append_point(snap(point, viewport), size, prototype, out);
  counters.screen_triangles += 2;
}

}  // namespace velum
