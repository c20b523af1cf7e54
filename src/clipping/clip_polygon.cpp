#include "clip_polygon.hpp"

#include <algorithm>

#include "../base/contract.hpp"
#include "cut.hpp"

namespace velum {

namespace {

constexpr unsigned bit(ClipPlane plane) {
  return 1u << static_cast<unsigned>(plane);
}

struct Codes {
  unsigned any = 0;    ///< planes that some vertex is outside of
  unsigned all = ~0u;  ///< planes that every vertex is outside of
  bool points = true;  ///< every vertex has w > 0
  bool finite = true;
};

Codes codes_of(std::span<const glm::dvec4> polygon, const ClipVolume& volume) {
  Codes codes;
  for (const glm::dvec4& vertex : polygon) {
    const unsigned code = outcode(vertex, volume);
    codes.any |= code;
    codes.all &= code;
    codes.points = codes.points && vertex.w > 0.0;
    codes.finite = codes.finite && is_finite(vertex);
  }
  return codes;
}

/// Sutherland–Hodgman for one plane. Writes at most 3n/2 vertices to `clipped`, returns how many.
///
/// Why triangles that share an edge agree on it bit for bit: what happens to an edge here depends on its two
/// ends and the plane only. A step that finds nothing outside is the identity, so it does not matter that one
/// triangle takes a plane's step and its neighbour skips it; and cut_edge() always goes from the inside to
/// the outside end, so it does not matter in which direction the edge is walked.
std::size_t clip_edges(std::span<const glm::dvec4> polygon, ClipPlane plane, const ClipVolume& volume,
                       glm::dvec4* clipped) {
  const ClipPlaneRow row = plane_of(volume, plane);
  std::size_t count = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec4& from = polygon[i];
    const glm::dvec4& to = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double d_from = signed_value(row, from);
    const double d_to = signed_value(row, to);
    if (d_from >= 0.0) clipped[count++] = from;
    // A vertex on the plane (d = 0) is its own cut point: no second one.
    if (d_from > 0.0 && d_to < 0.0) clipped[count++] = cut_edge(from, to, plane, volume).point;
    if (d_from < 0.0 && d_to > 0.0) clipped[count++] = cut_edge(to, from, plane, volume).point;
  }
  return count;
}

/// Leaves out what is no point and what equals its predecessor; fewer than three vertices are no polygon.
std::size_t tidy(std::span<glm::dvec4> polygon) {
  std::size_t count = 0;
  for (const glm::dvec4& vertex : polygon) {
    if (vertex.w > 0.0 && (count == 0 || vertex != polygon[count - 1])) polygon[count++] = vertex;
  }
  while (count > 1 && polygon[count - 1] == polygon[0]) --count;
  return count < 3 ? 0 : count;
}

}  // namespace

ClippedPolygon clip_against(const ClippedPolygon& polygon, ClipPlane plane, const ClipVolume& volume) {
  VELUM_REQUIRE(polygon.count >= 0 && polygon.count + polygon.count / 2 <= ClippedPolygon::capacity,
                {"polygon.count", polygon.count});
  ClippedPolygon clipped;
  clipped.count = static_cast<int>(clip_edges(polygon.span(), plane, volume, clipped.vertices.data()));
  const bool cuts = (codes_of(polygon.span(), volume).any & bit(plane)) != 0;
  clipped.cut_by = static_cast<Outcode>(polygon.cut_by | (cuts ? bit(plane) : 0u));
  return clipped;
}

ClippedPolygon clip_triangle(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c,
                             const ClipVolume& volume) {
  ClippedPolygon polygon{{a, b, c}, 3, 0};
  const Codes codes = codes_of(polygon.span(), volume);
  if (codes.any == 0 && codes.points && codes.finite) return polygon;  // trivial accept
  if (codes.all != 0 || !codes.finite) {                               // trivial reject
    polygon.count = 0;
    return polygon;
  }
  for (int i = 0; i < clip_plane_count && polygon.count > 0; ++i) {
    const ClipPlane plane = static_cast<ClipPlane>(i);
    // Asked anew for each plane: a cut can leave a vertex outside a plane that the triangle reached only by
    // rounding.
    if ((codes_of(polygon.span(), volume).any & bit(plane)) != 0)
      polygon = clip_against(polygon, plane, volume);
  }
  polygon.count = static_cast<int>(tidy({polygon.vertices.data(), static_cast<std::size_t>(polygon.count)}));
  return polygon;
}

std::vector<glm::dvec4> clip_polygon(std::span<const glm::dvec4> polygon) {
  const Codes codes = codes_of(polygon, {});
  if (polygon.size() < 3 || codes.all != 0 || !codes.finite) return {};
  std::vector<glm::dvec4> current(polygon.begin(), polygon.end());
  if (codes.any == 0 && codes.points) return current;
  std::vector<glm::dvec4> next;
  for (int i = 0; i < clip_plane_count; ++i) {
    const ClipPlane plane = static_cast<ClipPlane>(i);
    if ((codes_of(current, {}).any & bit(plane)) == 0) continue;
    next.resize(current.size() + current.size() / 2);
    next.resize(clip_edges(current, plane, {}, next.data()));
    current.swap(next);
  }
  current.resize(tidy(current));
  return current;
}

}  // namespace velum
