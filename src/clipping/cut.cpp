#include "cut.hpp"

#include <algorithm>
#include <cmath>

namespace velum {

namespace {

constexpr double k_overflow_scale = 0x1p-4;

const ClipPlaneRow& row_of(ClipPlane plane) {
  return clip_planes[static_cast<unsigned>(plane)];
}

/// t = d_in / (d_in - d_out): a sum of positive numbers below, so nothing cancels.
double crossing(const glm::dvec4& in, const glm::dvec4& out, const ClipPlaneRow& row) {
  const double d_in = signed_value(row, in);
  const double span = d_in - signed_value(row, out);
  if (std::isfinite(span)) return d_in / span;
  const double scaled_in = signed_value(row, in * k_overflow_scale);
  return scaled_in / (scaled_in - signed_value(row, out * k_overflow_scale));
}

/// The plane on the other side of the volume: 0↔1, 2↔3, 4↔5.
unsigned opposite(ClipPlane plane) {
  return static_cast<unsigned>(plane) ^ 1u;
}

/// Rounding can push a coordinate one ulp over a plane that both ends are inside of: put it back.
/// Planes that either end is outside of are left alone; their own turn comes. Where both planes of a pair
/// hold, w ≥ 0, so their two bounds never contradict each other.
void hold_inside(glm::dvec4& point, unsigned held, ClipPlane cut_plane) {
  for (unsigned i = 0; i < clip_planes.size(); ++i) {
    const ClipPlaneRow& row = clip_planes[i];
    if ((held >> i & 1u) == 0 || row.axis == row_of(cut_plane).axis) continue;
    if (signed_value(row, point) < 0.0) point[row.axis] = row.bound * point.w;
  }
}

}  // namespace

bool is_finite(const glm::dvec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

double between(double a, double b, double t) {
  const double difference = b - a;
  if (!std::isfinite(difference)) return 2.0 * between(0.5 * a, 0.5 * b, t);
  return std::clamp(a + t * difference, std::min(a, b), std::max(a, b));
}

Cut cut_edge(const glm::dvec4& in, const glm::dvec4& out, ClipPlane plane) {
  const ClipPlaneRow& row = row_of(plane);
  const double t = crossing(in, out, row);
  glm::dvec4 point;
  for (int axis = 0; axis < 4; ++axis) point[axis] = between(in[axis], out[axis], t);

  const unsigned held = ~(static_cast<unsigned>(outcode(in)) | static_cast<unsigned>(outcode(out)));
  // On plane i and inside the opposite one means w ≥ 0 (2w ≥ 0 for x and y, w ≥ z = 0 or z = w ≥ 0 for z).
  if ((held >> opposite(plane) & 1u) != 0) point.w = std::max(point.w, 0.0);
  point[row.axis] = row.bound * point.w + 0.0;  // + 0.0: never -0.0
  hold_inside(point, held, plane);
  return {point, t};
}

}  // namespace velum
