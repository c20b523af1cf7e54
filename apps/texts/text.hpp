#pragma once

#include <cstdint>
#include <string>

namespace velum_app {

/// A number as short text, the same in every locale: up to `digits` significant digits, "-0" as "0".
std::string number_text(double value, int digits = 7);
/// With exactly `decimals` places after the point.
std::string fixed_text(double value, int decimals);
/// 69451 → "69,451"
std::string grouped_text(std::uint64_t value);
/// 1 → "1 triangle", 12 → "12 triangles"
std::string counted_text(std::uint64_t count, const std::string& noun);
/// "12 triangles", and the segments and points where there are any; "20,000 points" of a cloud.
std::string primitives_text(std::uint64_t triangles, std::uint64_t segments, std::uint64_t points);
/// A share 0…1 → "23 %"; small ones keep a decimal: "0.4 %", "< 0.1 %".
std::string percent_text(double share);

/// Pads on the left (right) with spaces to a width in characters (UTF-8 code points).
std::string padded_left(const std::string& text, std::size_t width);
std::string padded_right(const std::string& text, std::size_t width);
/// Code points, not bytes.
std::size_t text_width(const std::string& text);

}  // namespace velum_app
