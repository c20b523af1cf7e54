#pragma once

#include <algorithm>
#include <limits>

namespace velum {

/// The values lower ≤ t ≤ upper of a ray's parameter; empty where lower > upper (or one of them is NaN).
struct Interval {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  static constexpr Interval empty() {
    return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  }
  constexpr bool is_empty() const { return !(lower <= upper); }
  constexpr bool contains(double t) const { return lower <= t && t <= upper; }
};

/// The common part, as the lecture "Raytracing" forms it: the larger beginning, the smaller end.
constexpr Interval intersect(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

}  // namespace velum
