#include <algorithm>

#include "stages.hpp"

namespace velum {
namespace {

bool is_finite(double v) {
  return v - v == 0.0;
}
bool is_finite(const glm::dvec4& v) {
  return is_finite(v.x) && is_finite(v.y) && is_finite(v.z) && is_finite(v.w);
}

bool is_culled(Facing facing, Cull cull) {
  return (cull == Cull::back && facing == Facing::back) || (cull == Cull::front && facing == Facing::front);
}

void count_planes(Outcode planes, std::uint64_t (&counts)[6]) {
  for (int i = 0; i < clip_plane_count; ++i) counts[i] += (planes >> i) & 1u;
}

/// The view volume's outcodes are at hand; only where they say so is there more to ask.
bool needs_cut(const AssembledTriangle& triangle) {
  if (triangle.some_outside == 0) return false;
  return std::any_of(triangle.vertices.begin(), triangle.vertices.end(),
                     [&](const glm::dvec4& v) { return !needs_no_cut(v, triangle.volume); });
}

TriangleFate fate_of(const AssembledTriangle& triangle, Cull cull, Counters& counters) {
  for (const glm::dvec4& vertex : triangle.vertices) {
    if (!is_finite(vertex)) {
      ++counters.not_finite;
      return TriangleFate::not_finite;
    }
  }
  if (triangle.all_outside != 0) {
    ++counters.trivially_rejected;
    count_planes(triangle.all_outside, counters.outside);
    return TriangleFate::rejected;
  }
  if (triangle.determinant == 0.0) ++counters.edge_on;
  if (triangle.facing == Facing::back) ++counters.back_facing;
  if (is_culled(triangle.facing, cull)) {
    ++counters.culled;
    return TriangleFate::culled;
  }
  if (needs_cut(triangle)) return TriangleFate::to_clip;
  ++counters.trivially_accepted;
  return TriangleFate::accepted;
}

/// The fan 0, i, i+1 over a convex polygon; every piece has the depth plane of the whole triangle.
void append_fan(std::span<const glm::dvec4> polygon, const ScreenTriangle& prototype, bool counter_clockwise,
                const Viewport& viewport, Counters& counters, std::vector<ScreenTriangle>& out) {
  ScreenTriangle piece = prototype;
  piece.vertices[0] = snap(polygon[0], viewport);
  piece.vertices[2] = snap(polygon[1], viewport);
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    piece.vertices[1] = piece.vertices[2];
    piece.vertices[2] = snap(polygon[i], viewport);
    // y points down on the picture, so counter-clockwise triangles have a negative doubled area there.
    const std::int64_t area = doubled_area(piece.vertices);
    if (area != 0 && (area < 0) != counter_clockwise) ++counters.reversed;
    ++counters.screen_triangles;
    out.push_back(piece);
  }
}

}  // namespace

void transform_vertices(std::span<const glm::vec3> positions, const glm::dmat4& clip_from_object,
                        ClipVertices& out) {
  out.positions.resize(positions.size());
  out.outcodes.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec4 clip = clip_position(clip_from_object, positions[i]);
    out.positions[i] = clip;
    out.outcodes[i] = outcode(clip);
  }
}

namespace {

AssembledTriangle assemble(const std::array<glm::dvec4, 3>& vertices, const std::array<Outcode, 3>& outcodes,
                           bool mirrored, Cull cull, const ClipVolume& volume, Counters& counters) {
  const unsigned a = outcodes[0], b = outcodes[1], c = outcodes[2];
  AssembledTriangle triangle;
  triangle.volume = volume;
  triangle.vertices = vertices;
  triangle.all_outside = static_cast<Outcode>(a & b & c);
  triangle.some_outside = static_cast<Outcode>(a | b | c);
  triangle.determinant = homogeneous_determinant(vertices[0], vertices[1], vertices[2]);
  triangle.facing = facing_of(triangle.determinant, mirrored);
  ++counters.triangles;
  triangle.fate = fate_of(triangle, cull, counters);
  return triangle;
}

}  // namespace

AssembledTriangle assemble(const ClipVertices& vertices, const glm::uvec3& indices, bool mirrored, Cull cull,
                           const ClipVolume& volume, Counters& counters) {
  const auto& [positions, outcodes] = vertices;
  return assemble({positions[indices.x], positions[indices.y], positions[indices.z]},
                  {outcodes[indices.x], outcodes[indices.y], outcodes[indices.z]}, mirrored, cull, volume,
                  counters);
}

AssembledTriangle assemble(const std::array<glm::dvec4, 3>& vertices, bool mirrored, Cull cull,
                           const ClipVolume& volume, Counters& counters) {
  return assemble(vertices, {outcode(vertices[0]), outcode(vertices[1]), outcode(vertices[2])}, mirrored,
                  cull, volume, counters);
}

void set_up(const AssembledTriangle& triangle, std::uint32_t primitive, const Viewport& viewport,
            Counters& counters, std::vector<ScreenTriangle>& out) {
  const bool is_whole = triangle.fate == TriangleFate::accepted;
  ClippedPolygon clipped;
  if (!is_whole) {
    clipped =
        clip_triangle(triangle.vertices[0], triangle.vertices[1], triangle.vertices[2], triangle.volume);
    if (clipped.count < 3) {
      ++counters.clipped_away;
      return;
    }
    ++counters.clipped;
    count_planes(clipped.cut_by, counters.cut_by);
  }
  const std::span<const glm::dvec4> polygon =
      is_whole ? std::span<const glm::dvec4>(triangle.vertices) : clipped.span();
  for (const glm::dvec4& vertex : polygon) {
    if (vertex.w > 0.0) continue;
    ++counters.at_eye;  // the centre of projection itself has no place on the picture
    return;
  }
  ScreenTriangle prototype;
  prototype.primitive = primitive;
  prototype.depth = depth_plane(triangle.vertices, triangle.determinant, viewport);
  append_fan(polygon, prototype, triangle.determinant >= 0.0, viewport, counters, out);
}

}  // namespace velum
