#include "cut.hpp"

#include <algorithm>
#include <cmath>

namespace velum {

namespace {

constexpr double k_overflow_scale = 0x1p-4;

/// How much of each end a crossing is made of; the two add up to 1.
struct Weights {
  double in;
  double out;
};

/// -d_out / (d_in - d_out) and d_in / (d_in - d_out): below stands a sum of positive numbers, so nothing
/// cancels, and each weight is relatively accurate, however near the crossing is to one end.
Weights weights_of(double d_in, double d_out) {
  const double span = d_in - d_out;
  return {-d_out / span, d_in / span};
}

Weights crossing(const glm::dvec4& in, const glm::dvec4& out, const ClipPlaneRow& row) {
  const double d_in = signed_value(row, in);
  const double d_out = signed_value(row, out);
  if (std::isfinite(d_in - d_out)) return weights_of(d_in, d_out);
  return weights_of(signed_value(row, in * k_overflow_scale), signed_value(row, out * k_overflow_scale));
}

/// Never beyond either end, so equal coordinates stay as they are and a positive w stays positive. Rounding
/// is monotone and the weights are not negative: where x ≤ w (or -x ≤ w, or z ≤ w, or 0 ≤ z) holds at both
/// ends, it holds for their mixtures too, exactly; and so it does with 2ⁿ·w, which rounds as w does. (The
/// usual in + t·(out - in) is not monotone in this sense.)
double mix(double in, double out, const Weights& weights) {
  return std::clamp(in * weights.in + out * weights.out, std::min(in, out), std::max(in, out));
}

/// The plane on the other side of the volume: front ↔ behind, left ↔ right, below ↔ above.
ClipPlane opposite(ClipPlane plane) {
  return static_cast<ClipPlane>(static_cast<unsigned>(plane) ^ 1u);
}

}  // namespace

bool is_finite(const glm::dvec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

Cut cut_edge(const glm::dvec4& in, const glm::dvec4& out, ClipPlane plane, const ClipVolume& volume) {
  const ClipPlaneRow row = plane_of(volume, plane);
  const Weights weights = crossing(in, out, row);
  glm::dvec4 point;
  for (int axis = 0; axis < 4; ++axis) point[axis] = mix(in[axis], out[axis], weights);

  // On plane i and inside the opposite one means w ≥ 0 (a multiple of w ≥ 0 for x and y, w ≥ z = 0 or z = w ≥
  // 0 for z), but the mixture can miss that where the ends have w of different signs.
  const ClipPlaneRow other = plane_of(volume, opposite(plane));
  const bool holds = signed_value(other, in) >= 0.0 && signed_value(other, out) >= 0.0;
  if (holds) point.w = std::max(point.w, 0.0);
  point[row.axis] = row.bound * point.w + 0.0;  // + 0.0: never -0.0
  return {point, weights.out};
}

}  // namespace velum
