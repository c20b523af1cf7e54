#include "box_projection.hpp"

#include <algorithm>

#include "depth_range.hpp"

namespace velum {
namespace {

double magnitude(double v) {
  return v < 0.0 ? -v : v;
}

glm::dmat4 absolute(const glm::dmat4& m) {
  return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]), glm::abs(m[3])};
}

/// The smallest and the largest of eight numbers; NaN may get lost.
struct Range {
  double lowest, highest;
};
Range range_of(const double (&v)[8]) {
  double low[4], high[4];
  for (int i = 0; i < 4; ++i) {
    low[i] = std::min(v[i], v[i + 4]);
    high[i] = std::max(v[i], v[i + 4]);
  }
  return {std::min(std::min(low[0], low[1]), std::min(low[2], low[3])),
          std::max(std::max(high[0], high[1]), std::max(high[2], high[3]))};
}

/// The pixels first … last whose centres lie between two pixel coordinates.
struct Centres {
  int first, last;
};
Centres centres_between(double lowest, double highest, int size) {
  const auto clamped = [size](double v) { return std::clamp(v - 0.5, -1.0, static_cast<double>(size)); };
  const double from = clamped(lowest), to = clamped(highest);
  const int first = static_cast<int>(from + 2.0) - 2;  // rounded down; from ≥ -1
  return {static_cast<double>(first) < from ? first + 1 : first, static_cast<int>(to + 2.0) - 2};
}

}  // namespace

/// The corners of a box in clip space: `base`, and from there along its edges.
struct BoxProjection::Corners {
  glm::dvec4 base, x, y, z;

  /// The largest value of a linear function f(v) of the corners.
  template <typename Function>
  double largest(const Function& f) const {
    return f(base) + std::max(f(x), 0.0) + std::max(f(y), 0.0) + std::max(f(z), 0.0);
  }
  void coordinate(int axis, double (&out)[8]) const {
    const double b = base[axis];
    out[0] = b;
    out[1] = b + x[axis];
    out[2] = b + y[axis];
    out[3] = out[1] + y[axis];
    for (int i = 0; i < 4; ++i) out[i + 4] = out[i] + z[axis];
  }
};

BoxProjection::BoxProjection(const glm::dmat4& clip_from_object, const Viewport& viewport, const Aabb& within)
    : clip_from_object_(clip_from_object), viewport_(viewport) {
  estimate_rounding(absolute(clip_from_object), within);
}

BoxProjection::BoxProjection(const ViewingTransform& clip_from_world, const Viewport& viewport,
                             const Aabb& within)
    : clip_from_object_(clip_from_world.clip_from_world()), viewport_(viewport) {
  glm::dmat4 magnitudes(8.0);  // a few stages, each of which rounds anew
  for (const Stage& stage : clip_from_world.stages()) magnitudes = absolute(stage.matrix) * magnitudes;
  estimate_rounding(magnitudes, within);
}

void BoxProjection::estimate_rounding(const glm::dmat4& magnitudes, const Aabb& within) {
  // A coordinate is a sum of four products, with fewer than ten roundings of 2⁻⁵³ of the terms' sizes on
  // either way, the vertex' own and the corner's here; cutting it off at a plane adds a few more.
  constexpr double unit = 0x1p-53 * 64.0;
  const glm::dvec3 reach = glm::max(glm::abs(within.lower), glm::abs(within.upper));
  rounding_ = (magnitudes * glm::dvec4(reach, 1.0)) * unit;
}

bool BoxProjection::is_outside(const Corners& corners) const {
  const glm::dvec4& e = rounding_;
  using Vector = const glm::dvec4&;
  return corners.largest([](Vector v) { return v.w + v.x; }) < -(e.w + e.x) ||
         corners.largest([](Vector v) { return v.w - v.x; }) < -(e.w + e.x) ||
         corners.largest([](Vector v) { return v.w + v.y; }) < -(e.w + e.y) ||
         corners.largest([](Vector v) { return v.w - v.y; }) < -(e.w + e.y) ||
         corners.largest([](Vector v) { return v.z; }) < -e.z ||
         corners.largest([](Vector v) { return v.w - v.z; }) < -(e.w + e.z);
}

BoxOnPicture BoxProjection::bounds_of(const Corners& corners, double smallest_w) const {
  double x[8], y[8], z[8], w[8];
  corners.coordinate(0, x);
  corners.coordinate(1, y);
  corners.coordinate(2, z);
  corners.coordinate(3, w);
  for (int i = 0; i < 8; ++i) {
    const double over_w = 1.0 / w[i];
    x[i] *= over_w;
    y[i] *= over_w;
    z[i] = (w[i] - z[i]) * over_w;
  }
  const Range xs = range_of(x), ys = range_of(y);
  const double nearest = range_of(z).highest;
  // Errors of the quotients: of the numerator, of the denominator, and of the division.
  const double over_w = 1.0 / smallest_w;
  const auto error = [&](double numerator, double quotient) {
    return (numerator + rounding_.w * quotient) * over_w * 1.01 + 0x1p-50 * quotient;
  };
  const double snapping = 1.0 / 256.0;
  const double x_grown =
      0.5 * viewport_.width * error(rounding_.x, 1.0 + std::max(-xs.lowest, xs.highest)) + snapping;
  const double y_grown =
      0.5 * viewport_.height * error(rounding_.y, 1.0 + std::max(-ys.lowest, ys.highest)) + snapping;
  const glm::dvec2 upper_left = viewport_.pixel_from_ndc(xs.lowest, ys.highest);
  const glm::dvec2 lower_right = viewport_.pixel_from_ndc(xs.highest, ys.lowest);
  const Centres columns = centres_between(upper_left.x - x_grown, lower_right.x + x_grown, viewport_.width);
  const Centres rows = centres_between(upper_left.y - y_grown, lower_right.y + y_grown, viewport_.height);
  const double depth_error = error(rounding_.z + rounding_.w, 1.0 + magnitude(nearest));
  return {false,
          {columns.first, rows.first, std::max(columns.last - columns.first + 1, 0),
           std::max(rows.last - rows.first + 1, 0)},
          unit_float(nearest + depth_error)};
}

BoxOnPicture BoxProjection::operator()(const Aabb& box) const {
  const glm::dvec3 size = box.upper - box.lower;
  const glm::dmat4& m = clip_from_object_;
  return judge({((m[0] * box.lower.x + m[1] * box.lower.y) + m[2] * box.lower.z) + m[3], m[0] * size.x,
                m[1] * size.y, m[2] * size.z});
}

BoxOnPicture BoxProjection::operator()(const OrientedBox& box) const {
  const glm::dmat4& m = clip_from_object_;
  const auto direction = [&](const glm::dvec3& v) { return (m[0] * v.x + m[1] * v.y) + m[2] * v.z; };
  return judge({direction(box.corner) + m[3], direction(box.x), direction(box.y), direction(box.z)});
}

BoxOnPicture BoxProjection::judge(const Corners& corners) const {
  if (is_outside(corners)) return {true, {}, 0.0f};
  const double smallest_w = -corners.largest([](const glm::dvec4& v) { return -v.w; });
  // So far from the eye that the roundings are small beside w; not so if anything is not a number.
  constexpr double many = 1048576.0;
  const bool is_bounded = smallest_w > 0.0 && smallest_w > many * rounding_.w;
  if (!is_bounded) return {false, {0, 0, viewport_.width, viewport_.height}, 1.0f};
  return bounds_of(corners, smallest_w);
}

}  // namespace velum
