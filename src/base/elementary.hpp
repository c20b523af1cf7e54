#pragma once

namespace velum {

/// Elementary functions that give the same bits on every machine: built from IEEE +, -, ·, /, sqrt,
/// comparisons and integer operations only, in a written-down order. The C library's differ in the last bit
/// with and without fused multiply-add, so nothing that reaches a byte of a picture may call them (sqrt is
/// exact and may).
///
/// Each states a bound on its error in units in the last place (ulp) of the result, for every finite
/// argument; tests/base measures it against long double. Angles are in radians. NaN in, NaN out; the other
/// special arguments (±0, infinities, domain errors) give what ISO C, Annex F, says, without raising
/// anything.
///
/// Sources: the polynomials are those of fdlibm (Sun Microsystems, 1993); angles are reduced with as many
/// bits of 2/π as they need (Payne & Hanek, "Radian Reduction for Trigonometric Functions", 1983), whatever
/// their size; pow takes a double-double logarithm (Dekker, "A Floating-Point Technique for Extending the
/// Available Precision", 1971).
namespace elementary {

double sin(double x);              ///< ≤ 1 ulp; infinity gives NaN
double cos(double x);              ///< ≤ 1 ulp; infinity gives NaN
double tan(double x);              ///< ≤ 2.5 ulp; infinity gives NaN
double asin(double x);             ///< ≤ 1 ulp; |x| > 1 gives NaN
double acos(double x);             ///< ≤ 1 ulp; |x| > 1 gives NaN
double atan(double x);             ///< ≤ 1 ulp
double atan2(double y, double x);  ///< ≤ 2 ulp; the quadrant is that of the point (x, y), signed zeros too
double exp(double x);              ///< ≤ 1 ulp
double log(double x);              ///< ≤ 1 ulp; 0 gives -infinity, x < 0 gives NaN
double pow(double x, double y);    ///< ≤ 1 ulp; x < 0 with a fractional y gives NaN; pow(x, 0) = 1

/// Exact: largest whole number ≤ x, smallest ≥ x; keep -0. (libm's floor is a call where SSE4.1 is not
/// assumed.)
double floor(double x);
double ceil(double x);

}  // namespace elementary

inline constexpr double pi = 3.14159265358979323846;
constexpr double radians(double degrees) {
  return degrees * (pi / 180.0);
}
constexpr double degrees(double radians_in) {
  return radians_in * (180.0 / pi);
}

}  // namespace velum
