#pragma once

#include <string>

namespace velum {

/// A number for a diagram's label: up to `digits` significant digits, the same in every locale, "-0" as "0".
/// @pre 1 ≤ digits ≤ 17
std::string short_number(double value, int digits = 4);

}  // namespace velum
