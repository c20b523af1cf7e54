#pragma once

#include <cstdint>
#include <type_traits>

namespace velum {

/// How depths are kept in the buffer. `reversed` is velum's own; the others are for teaching: their value
/// decides what is seen, with the same tie rule, and the buffer holds the reversed depth made back from it.
enum class DepthFormat {
  reversed,  ///< r = 1 - z in float32: finest where perspective compresses
  float_z,   ///< z = fl(1 - r) in float32
  z24,       ///< whole numbers floor(z·(2ⁿ - 1) + 0.5) with n = 24 bits
  z16,
  z8,  ///< 0 … 255, as in the lecture's example
};

/// 2ⁿ - 1, the value of z = 1. @pre a quantised format
constexpr std::uint32_t largest_value(DepthFormat format) {
  return format == DepthFormat::z24 ? 0xFFFFFFu : (format == DepthFormat::z16 ? 0xFFFFu : 0xFFu);
}

/// The whole number that a quantised format keeps for a reversed depth in [0, 1].
constexpr std::uint32_t quantised_depth(DepthFormat format, float r) {
  const double z = 1.0 - static_cast<double>(r);
  return static_cast<std::uint32_t>(z * largest_value(format) + 0.5);
}

/// What the buffer holds for a reversed depth in [0, 1]: monotone in r, and different for different values of
/// the format, so that comparing it is comparing the format's values.
template <DepthFormat format>
constexpr float stored_depth(float r) {
  if constexpr (format == DepthFormat::reversed) {
    return r;
  } else if constexpr (format == DepthFormat::float_z) {
    return 1.0f - (1.0f - r);  // the outer difference is exact
  } else {
    const std::uint32_t largest = largest_value(format);
    return static_cast<float>(static_cast<double>(largest - quantised_depth(format, r)) / largest);
  }
}

/// Calls `work(constant)` with the format as a compile-time constant, so that the usual one costs nothing.
template <typename Work>
constexpr auto with_format(DepthFormat format, const Work& work) {
  switch (format) {
    case DepthFormat::float_z:
      return work(std::integral_constant<DepthFormat, DepthFormat::float_z>{});
    case DepthFormat::z24:
      return work(std::integral_constant<DepthFormat, DepthFormat::z24>{});
    case DepthFormat::z16:
      return work(std::integral_constant<DepthFormat, DepthFormat::z16>{});
    case DepthFormat::z8:
      return work(std::integral_constant<DepthFormat, DepthFormat::z8>{});
    case DepthFormat::reversed:
      break;
  }
  return work(std::integral_constant<DepthFormat, DepthFormat::reversed>{});
}

/// The same for a format known only at run time.
constexpr float stored_depth(DepthFormat format, float r) {
  return with_format(format, [r](auto constant) { return stored_depth<constant.value>(r); });
}

}  // namespace velum
