#include "file_colours.hpp"

#include "../base/elementary.hpp"

namespace velum {

float linear_from_srgb_value(double value) {
  if (!(value > 0.0)) return 0.0f;
  if (value >= 1.0) return 1.0f;
  const double linear = value <= 0.04045 ? value / 12.92 : elementary::pow((value + 0.055) / 1.055, 2.4);
  return static_cast<float>(linear);
}

}  // namespace velum
