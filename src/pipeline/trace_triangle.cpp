#include "trace_triangle.hpp"

#include "../base/contract.hpp"
#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "check_request.hpp"

namespace velum {
namespace {

/// The corners after clipping; none where the pipeline draws nothing.
std::vector<PlacedPoint> polygon_of(const TriangleTrace& trace, const Viewport& viewport) {
  if (trace.pieces.empty()) return {};
  const std::array<glm::dvec4, 3>& v = trace.assembled.vertices;
  const ClipVolume& volume = trace.assembled.volume;
  std::vector<PlacedPoint> polygon;
  if (trace.assembled.fate == TriangleFate::accepted) {
    for (const glm::dvec4& vertex : v) polygon.push_back(place_on_picture(vertex, viewport, volume));
    return polygon;
  }
  const ClippedPolygon clipped = clip_triangle(v[0], v[1], v[2], volume);
  for (const glm::dvec4& vertex : clipped.span()) {
    polygon.push_back(place_on_picture(vertex, viewport, volume));
  }
  return polygon;
}

Outcode planes_that_cut(const AssembledTriangle& triangle) {
  if (triangle.fate != TriangleFate::to_clip) return 0;
  return clip_triangle(triangle.vertices[0], triangle.vertices[1], triangle.vertices[2], triangle.volume)
      .cut_by;
}

VertexTrace trace_vertex(std::uint32_t index, const glm::vec3& position, const glm::dmat4& world_from_object,
                         const ViewingTransform& viewing) {
  VertexTrace vertex;
  vertex.index = index;
  vertex.object = glm::dvec3(position);
  vertex.images = viewing.images_of(world_from_object * glm::dvec4(vertex.object, 1.0));
  return vertex;
}

}  // namespace

PlacedPoint place_on_picture(const glm::dvec4& clip, const Viewport& viewport, const ClipVolume& volume) {
  PlacedPoint point;
  point.clip = clip;
  point.ndc = {clip.x / clip.w, clip.y / clip.w, clip.z / clip.w};
  point.pixel = viewport.pixel_from_ndc(point.ndc.x, point.ndc.y);
  point.is_snapped = needs_no_cut(clip, volume);
  if (point.is_snapped) point.snapped = snap(clip, viewport);
  return point;
}

TriangleTrace trace_triangle(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                             std::uint32_t primitive) {
  VELUM_REQUIRE(primitive < scene.primitive_count(), {"primitive", primitive},
                {"primitive_count", scene.primitive_count()});
  const FloatingPointScope floating_point;
  requested_rect(settings);
  const ViewingTransform viewing = requested_view(camera, settings);
  const Viewport viewport{settings.width, settings.height};

  TriangleTrace trace;
  trace.primitive = primitive;
  trace.place = scene.place(primitive);
  const Instance& instance = scene.instances()[trace.place.instance];
  const Mesh& mesh = scene.meshes()[instance.mesh];
  if (trace.place.kind != PrimitiveKind::triangle) {
    throw Error(ErrorKind::usage, "primitive " + std::to_string(primitive) + " is a segment or a point",
                "trace_triangle", "give the id of a triangle");
  }
  const glm::uvec3 indices = mesh.triangles[trace.place.index];
  trace.mirrored = is_mirroring(instance.world_from_object);

  std::array<glm::vec3, 3> positions;
  for (int i = 0; i < 3; ++i) {
    const auto corner = static_cast<std::size_t>(i);
    positions[corner] = mesh.positions[indices[i]];
    trace.vertices[corner] = trace_vertex(indices[i], positions[corner], instance.world_from_object, viewing);
  }
  ClipVertices clip;
  transform_vertices(positions, viewing.clip_from_object(instance.world_from_object), clip);
  for (std::size_t i = 0; i < 3; ++i) {
    trace.vertices[i].clip = clip.positions[i];
    trace.vertices[i].code = clip.outcodes[i];
  }
  Counters counters;
  trace.assembled =
      assemble(clip, {0, 1, 2}, trace.mirrored, settings.cull, clip_volume_of(settings), counters);
  if (trace.assembled.fate == TriangleFate::accepted || trace.assembled.fate == TriangleFate::to_clip) {
    set_up(trace.assembled, primitive, viewport, counters, trace.pieces);
  }
  trace.cut_by = planes_that_cut(trace.assembled);
  trace.polygon = polygon_of(trace, viewport);
  return trace;
}

}  // namespace velum
