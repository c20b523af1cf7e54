#include "kd_split.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace velum {
namespace {

/// A convex polygon; a triangle that six planes cut has nine corners at most.
struct Part {
  std::array<glm::dvec3, 9> corners;
  std::size_t count = 0;

  void add(const glm::dvec3& corner) { corners[count++] = corner; }
};

/// What lies on one side of a plane across an axis. @param sign  1: above the place, -1: below
Part cut(const Part& part, int axis, double place, double sign) {
  Part result;
  for (std::size_t i = 0; i < part.count; ++i) {
    const glm::dvec3& p = part.corners[i];
    const glm::dvec3& q = part.corners[(i + 1) % part.count];
    const double from = (p[axis] - place) * sign, to = (q[axis] - place) * sign;
    if (from >= 0.0) result.add(p);
    if ((from < 0.0) == (to < 0.0)) continue;
    glm::dvec3 crossing = p + (q - p) * (from / (from - to));
    crossing[axis] = place;
    result.add(crossing);
  }
  return result;
}

}  // namespace

KdCost::KdCost(const KdSettings& settings, const Box& cell, int axis)
    : settings_(settings),
      lower_(static_cast<double>(cell.lower[axis])),
      upper_(static_cast<double>(cell.upper[axis])) {
  const glm::dvec3 size = glm::dvec3(cell.upper) - glm::dvec3(cell.lower);
  across_ = size[(axis + 1) % 3] * size[(axis + 2) % 3];
  around_ = size[(axis + 1) % 3] + size[(axis + 2) % 3];
  per_area_ = 1.0 / (across_ + around_ * size[axis]);
}

double KdCost::without_bonus(double place, double left, double right) const {
  const double left_area = across_ + around_ * (place - lower_);
  const double right_area = across_ + around_ * (upper_ - place);
  return settings_.step_cost + settings_.triangle_cost * (left_area * left + right_area * right) * per_area_;
}

double KdCost::operator()(double place, double left, double right) const {
  const double bonus = left == 0.0 || right == 0.0 ? 1.0 - settings_.empty_bonus : 1.0;
  return bonus * without_bonus(place, left, right);
}

std::optional<Box> box_of_part(const Triangle& triangle, const Box& cell, double pad) {
  Part part;
  for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c}) part.add(corner);
  for (int axis = 0; axis < 3; ++axis) {
    part = cut(part, axis, static_cast<double>(cell.lower[axis]) - pad, 1.0);
    part = cut(part, axis, static_cast<double>(cell.upper[axis]) + pad, -1.0);
  }
  if (part.count == 0) return {};
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    double lower = part.corners[0][axis], upper = lower;
    for (std::size_t i = 1; i < part.count; ++i) {
      lower = std::min(lower, part.corners[i][axis]);
      upper = std::max(upper, part.corners[i][axis]);
    }
    box.lower[axis] = std::max(float_below(lower - pad), cell.lower[axis]);
    box.upper[axis] = std::min(float_above(upper + pad), cell.upper[axis]);
  }
  if (box.is_empty()) return {};
  return box;
}

float float_below(double v) {
  const auto f = static_cast<float>(v);
  return f - std::fabs(f) * 0x1.0p-23f - std::numeric_limits<float>::min();
}

float float_above(double v) {
  return -float_below(-v);
}

}  // namespace velum
