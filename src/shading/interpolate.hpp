#pragma once

#include <array>

namespace velum {

/// The barycentric mean of three vertex attributes, as differences to the first: where all three are equal
/// the result is exactly that value (an opaque surface stays opaque), though the weights' sum is 1 only up to
/// rounding.
template <typename Vector, typename Weights>
Vector interpolate(const std::array<Vector, 3>& values, const Weights& weights) {
  return (values[0] + (values[1] - values[0]) * weights.y) + (values[2] - values[0]) * weights.z;
}

}  // namespace velum
