#include "orientation.hpp"

#include <array>

namespace velum {
namespace {

constexpr double unit_roundoff = 1.0 / 9007199254740992.0;  // 2^-53

int sign(double x) {
  return (x > 0.0) - (x < 0.0);
}

// x + y = sum + error, exactly (Knuth 1969; Shewchuk 1997, theorem 7).
void two_sum(double x, double y, double& sum, double& error) {
  sum = x + y;
  const double y_virtual = sum - x;
  const double x_virtual = sum - y_virtual;
  error = (x - x_virtual) + (y - y_virtual);
}

// The sign of a sum of doubles, by growing a nonoverlapping expansion (Shewchuk 1997, theorem 10): its last
// component that is not zero has the sign of the whole.
int sign_of_sum(const std::array<double, 6>& terms) {
  std::array<double, 6> expansion{};
  for (std::size_t n = 0; n < terms.size(); ++n) {
    double carry = terms[n];
    for (std::size_t i = 0; i < n; ++i) {
      double error = 0.0;
      two_sum(carry, expansion[i], carry, error);
      expansion[i] = error;
    }
    expansion[n] = carry;
  }
  for (std::size_t i = expansion.size(); i-- > 0;) {
    if (expansion[i] != 0.0) return sign(expansion[i]);
  }
  return 0;
}

}  // namespace

// J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997.
// Departs from it where float coordinates allow: their products are exact in double, so the second stage is
// already exact.
int orientation(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  const glm::dvec2 p(a), q(b), r(c);
  const double left = (p.x - r.x) * (q.y - r.y);
  const double right = (p.y - r.y) * (q.x - r.x);
  const double determinant = left - right;
  const double magnitude = (left < 0.0 ? -left : left) + (right < 0.0 ? -right : right);
  const double bound = (3.0 + 16.0 * unit_roundoff) * unit_roundoff * magnitude;
  if (determinant > bound || determinant < -bound) return sign(determinant);
  return sign_of_sum({p.x * q.y, -(p.y * q.x), q.x * r.y, -(q.y * r.x), r.x * p.y, -(r.y * p.x)});
}

}  // namespace velum
