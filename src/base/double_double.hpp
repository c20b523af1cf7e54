#pragma once

/// Unevaluated sums of two doubles, about 106 bits: Dekker, "A Floating-Point Technique for Extending the
/// Available Precision", 1971. Without fused multiply-add, so that every machine gives the same bits.
namespace velum::elementary {

/// The value high + low, |low| ≤ ulp(high).
struct DoubleDouble {
  double high;
  double low;
};

/// a + b exactly. @pre |a| ≥ |b| or a == 0
inline DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b exactly (Knuth 1969).
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// The upper 26 bits of a and the rest (Veltkamp 1968). @pre |a| < 2^995
inline DoubleDouble split(double a) {
  const double shifted = a * 134217729.0;  // 2^27 + 1
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

/// a · b exactly, barring underflow.
inline DoubleDouble two_product(double a, double b) {
  const double product = a * b;
  const DoubleDouble x = split(a);
  const DoubleDouble y = split(b);
  const double error = ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low;
  return {product, error};
}

inline DoubleDouble add(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = two_sum(a.high, b.high);
  return quick_two_sum(sum.high, sum.low + (a.low + b.low));
}

inline DoubleDouble multiply(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = two_product(a.high, b.high);
  return quick_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble multiply(const DoubleDouble& a, double b) {
  const DoubleDouble product = two_product(a.high, b);
  return quick_two_sum(product.high, product.low + a.low * b);
}

/// a / b for an exact a.
inline DoubleDouble divide(double a, const DoubleDouble& b) {
  const double quotient = a / b.high;
  const DoubleDouble product = two_product(quotient, b.high);
  const double remainder = ((a - product.high) - product.low) - quotient * b.low;
  return quick_two_sum(quotient, remainder / b.high);
}

}  // namespace velum::elementary
