#pragma once

#include <glm/vec4.hpp>

#include "outcode.hpp"

namespace velum {

/// The part of a segment inside the canonical view volume.
struct ClippedSegment {
  bool visible = false;
  glm::dvec4 a{0.0};  ///< homogeneous clip space
  glm::dvec4 b{0.0};
  double t0 = 0.0;  ///< parameter of a on the original segment, 0…1
  double t1 = 1.0;  ///< parameter of b
  int plane0 = -1;  ///< the plane that cut at a (row of clip_planes), or -1
  int plane1 = -1;  ///< the plane that cut at b, or -1
};

/// Cohen–Sutherland in 3D with 6-bit outcodes (Sproull & Sutherland 1968; Newman & Sproull 1979;
/// homogeneous): trivial accept, trivial reject, or cut at one plane and look again.
ClippedSegment clip_segment(const glm::dvec4& a, const glm::dvec4& b);

/// A point is kept if its outcode is 0.
constexpr bool clip_point(const glm::dvec4& p) {
  return outcode(p) == 0;
}

}  // namespace velum
