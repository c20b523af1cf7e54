#pragma once

#include <glm/vec4.hpp>

#include "outcode.hpp"

namespace velum {

/// The part of a segment inside the canonical view volume.
struct ClippedSegment {
  bool visible = false;  ///< if false, all else is as it stands here
  glm::dvec4 a{0.0};     ///< homogeneous clip space; outcode 0 exactly, w > 0
  glm::dvec4 b{0.0};
  double t0 =
      0.0;  ///< parameter of a on the original segment a + t·(b - a), 0…1, linear in clip (and object) space
  double t1 = 1.0;  ///< parameter of b; t0 ≤ t1
  int plane0 = -1;  ///< the plane that cut at a (row of clip_planes), or -1
  int plane1 = -1;  ///< the plane that cut at b, or -1
};

/// Cohen–Sutherland in 3D with 6-bit outcodes (Sproull & Sutherland 1968; Newman & Sproull 1979;
/// homogeneous): trivial accept, trivial reject, or cut at one plane and look again.
///
/// The volume is the set where six linear forms of (x,y,z,w) are ≥ 0: convex in four dimensions, so a segment
/// that passes from w > 0 to w < 0 (through the plane of the eye) still leaves *one* visible piece; the
/// "external" piece that dividing first would draw never appears.
///
/// @param a,b  homogeneous clip space, any w
/// @post swapping a and b swaps the result, its points bit for bit (t0 and t1 become 1 - t1 and 1 - t0 up to
///       rounding); a segment inside comes back bit-identical, so clipping twice changes nothing
/// @post the cut points of an edge equal those clip_triangle() makes on it
/// A segment that only touches the volume is visible, with a equal to b. Nothing is visible if a coordinate
/// is NaN or infinite, or if an end of the piece is (0,0,0,0), which is no point (the segment then points
/// exactly at the eye and has no length on the picture).
ClippedSegment clip_segment(const glm::dvec4& a, const glm::dvec4& b);

/// A point is kept if its outcode is 0, and (0,0,0,0) is no point.
constexpr bool clip_point(const glm::dvec4& p) {
  return outcode(p) == 0 && p.w > 0.0;
}

}  // namespace velum
