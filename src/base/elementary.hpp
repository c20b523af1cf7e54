#pragma once

namespace velum {

/// Elementary functions that give the same bits on every machine: built from IEEE +, -, ·, / and comparisons
/// only, in a written-down order. The C library's differ in the last bit with and without fused multiply-add,
/// so nothing that reaches a byte of a picture may call them (sqrt is exact and may).
///
/// Each states its largest error in units in the last place (ulp), as tests/base measures it against long
/// double. Arguments are in radians. NaN in, NaN out.
namespace elementary {

double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double pow(double x, double y);

/// Exact: largest whole number ≤ x, smallest ≥ x. (libm's floor is a call where SSE4.1 is not assumed.)
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
