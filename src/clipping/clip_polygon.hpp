#pragma once

#include <array>
#include <cstddef>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "clip_volume.hpp"

namespace velum {

/// A convex polygon in homogeneous clip space: what is left of a triangle.
struct ClippedPolygon {
  /// In exact arithmetic a triangle gains at most one vertex per plane: 9. Rounding can leave a polygon
  /// non-convex by an ulp, and then a plane can cut it in more than one place. Of n vertices at most n/2 runs
  /// lie outside, each run gains one vertex: 3 → 4 → 6 → 9 → 13 → 19 → 28 holds for any input whatsoever.
  static constexpr int capacity = 28;
  std::array<glm::dvec4, capacity> vertices;
  int count = 0;
  Outcode cut_by = 0;  ///< planes that cut something off, or everything, up to the first that left nothing

  std::span<const glm::dvec4> span() const { return {vertices.data(), static_cast<std::size_t>(count)}; }
};

/// Clips a triangle against the volume, by default the canonical view volume (Sutherland & Hodgman 1974,
/// homogeneous as Blinn & Newell 1978), plane after plane in table order. The departures from the textbook
/// make it exact where it can be: each cut goes from the inside to the outside end, *sets* the cut
/// coordinate, and leaves the others inside the planes that both ends are inside of.
///
/// @param a,b,c  homogeneous clip space, any w (w ≤ 0: behind the eye)
/// @post every vertex has outcode 0 with respect to the volume, exactly, and w > 0
/// @post a triangle inside the volume comes back bit-identical; so clipping twice changes nothing
/// @post triangles that share an edge get the same vertices on it, bit for bit
/// @post no two consecutive vertices are equal, unless the triangle came back as it was
/// An empty result has count 0: fewer than three vertices are left, or an input is NaN or infinite. A vertex
/// (0,0,0,0) is no point and is left out (where clipping makes one, the triangle passes through the eye
/// exactly edge-on and has no area).
ClippedPolygon clip_triangle(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c,
                             const ClipVolume& volume = {});

/// The same for any convex polygon and the canonical view volume, in either orientation; fewer than three
/// vertices give an empty result.
std::vector<glm::dvec4> clip_polygon(std::span<const glm::dvec4> polygon);

/// One plane's step, for those who want to watch: clips `polygon` against one plane only. clip_triangle() is
/// these steps in table order, without the vertices that are no point or equal their predecessor.
/// @pre  polygon.count ≤ capacity·2/3, which clip_triangle()'s own steps keep; finite vertices
/// @post every vertex is inside `plane` and inside every plane that all vertices of `polygon` are inside of
ClippedPolygon clip_against(const ClippedPolygon& polygon, ClipPlane plane, const ClipVolume& volume = {});

}  // namespace velum
