#pragma once

#include <array>
#include <vector>

#include "../clipping/clip_polygon.hpp"

namespace velum {

/// A vertex that takes part in clipping. 0, 1, 2 are the triangle's own; each cut makes one more.
struct TracedVertex {
  glm::dvec4 position{0.0};  ///< homogeneous clip space
  Outcode code = 0;
  /// Where it comes from, if a plane made it: the edge's ends by number, the parameter from the inside end
  /// (0) to the outside end (1), linear in clip space, and the ends' signed values: t = d_in / (d_in -
  /// d_out).
  int inside = -1;
  int outside = -1;
  double t = 0.0;
  double d_in = 0.0;
  double d_out = 0.0;
  ClipPlane plane = ClipPlane::front;

  bool is_cut() const { return inside >= 0; }
};

/// One plane's turn.
struct ClipStep {
  ClipPlane plane = ClipPlane::front;
  bool cuts = false;         ///< something lay outside of it
  std::vector<int> polygon;  ///< what is left after it: vertex numbers in order
  std::vector<int> made;     ///< the numbers of the vertices it made
  std::vector<int> removed;  ///< the numbers of the vertices it cut off
};

enum class ClipVerdict {
  accepted,      ///< trivially: no vertex is outside of any plane
  rejected,      ///< trivially: every vertex is outside of one and the same plane, or one is not finite
  clipped,       ///< something is left
  clipped_away,  ///< the planes left nothing
};

/// What clip_triangle() did, step by step.
struct ClipTrace {
  std::vector<TracedVertex> vertices;
  Outcode all_outside = 0;   ///< AND of the triangle's outcodes
  Outcode some_outside = 0;  ///< OR
  ClipVerdict verdict = ClipVerdict::accepted;
  std::array<ClipStep, clip_plane_count> steps;
  /// The result: the last step's polygon without vertices that are no point or equal their predecessor.
  std::vector<int> result;
};

/// Follows a triangle through the six planes in table order. Each step is clip_against(), each new vertex
/// cut_edge(), and the result is clip_triangle()'s, bit for bit (checked).
/// @param a,b,c  homogeneous clip space, any w
ClipTrace trace_clipping(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c);

}  // namespace velum
