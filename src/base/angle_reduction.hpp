#pragma once

#include "double_double.hpp"

namespace velum::elementary {

/// An angle as quadrant·π/2 + remainder, |remainder| ≤ π/4 or a hair more. The quadrant is taken modulo 4.
struct ReducedAngle {
  unsigned quadrant;
  DoubleDouble remainder;  ///< relative error below 2^-60
};

/// Payne & Hanek, "Radian Reduction for Trigonometric Functions", SIGNUM Newsletter 1983: multiplies by the
/// bits of 2/π that matter for this exponent, in integers. @param x radians, finite, any size
ReducedAngle reduce_angle(double x);

}  // namespace velum::elementary
