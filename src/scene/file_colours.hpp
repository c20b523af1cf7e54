#pragma once

namespace velum {

/// sRGB value 0…1 → linear 0…1 (IEC 61966-2-1), for codes finer than 8 bits. Below 0 and NaN give 0, above 1
/// gives 1.
float linear_from_srgb_value(double value);

}  // namespace velum
