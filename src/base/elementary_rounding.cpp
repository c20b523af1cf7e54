#include <cstdint>

#include "double_bits.hpp"
#include "elementary.hpp"

namespace velum::elementary {

double floor(double x) {
  // From 2^52 on every double is whole; NaN and infinity go the same way.
  if (!(magnitude(x) < 0x1p52)) return x;
  const double truncated = static_cast<double>(static_cast<std::int64_t>(x));
  return with_sign_of(truncated > x ? truncated - 1.0 : truncated, x);
}

double ceil(double x) {
  return -floor(-x);
}

}  // namespace velum::elementary
