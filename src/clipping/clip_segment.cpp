#include "clip_segment.hpp"

#include <algorithm>
#include <bit>

#include "../base/contract.hpp"
#include "cut.hpp"

namespace velum {

namespace {

struct End {
  glm::dvec4 point;
  double t;
  int plane;
  unsigned code;
};

End end_at(const glm::dvec4& point, double t) {
  return {point, t, -1, outcode(point)};
}

/// Moves the outside end to plane i.
void move_to_plane(End& outside, const End& inside, int plane) {
  // An inside end exactly on the plane is itself the crossing.
  const ClipPlaneRow& row = clip_planes[static_cast<unsigned>(plane)];
  const bool touches = signed_value(row, inside.point) == 0.0;
  const Cut cut =
      touches ? Cut{inside.point, 0.0} : cut_edge(inside.point, outside.point, static_cast<ClipPlane>(plane));
  outside = {cut.point, inside.t + cut.t * (outside.t - inside.t), plane, outcode(cut.point)};
}

}  // namespace

ClippedSegment clip_segment(const glm::dvec4& a, const glm::dvec4& b) {
  if (!is_finite(a) || !is_finite(b)) return {};
  End from = end_at(a, 0.0);
  End to = end_at(b, 1.0);
  // A cut at plane i keeps both ends inside the planes before i: at most one turn per plane.
  for (int turn = 0; turn < clip_plane_count && (from.code | to.code) != 0; ++turn) {
    if ((from.code & to.code) != 0) return {};
    // The lowest plane that either end is outside of: exactly one is, so the choice is the same for (b, a).
    const int plane = std::countr_zero(from.code | to.code);
    if ((from.code >> plane & 1u) != 0) {
      move_to_plane(from, to, plane);
    } else {
      move_to_plane(to, from, plane);
    }
  }
  VELUM_REQUIRE((from.code | to.code) == 0, {"from.code", from.code}, {"to.code", to.code});
  if (!(from.point.w > 0.0 && to.point.w > 0.0)) return {};
  return {true, from.point, to.point, from.t, to.t, from.plane, to.plane};
}

}  // namespace velum
