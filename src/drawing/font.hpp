#pragma once

#include <array>
#include <cstdint>

namespace velum {

/// A letter of 5×7 dots: five columns from left to right, bit 0 of each is the top row.
using Glyph = std::array<std::uint8_t, 5>;

inline constexpr int glyph_width = 5;
inline constexpr int glyph_height = 7;
/// From one letter to the next: five dots and one free column.
inline constexpr int glyph_advance = glyph_width + 1;

/// The dots of a printable ASCII character; anything else is shown as a box. In the public domain: the plain
/// shapes of dot-matrix displays.
const Glyph& glyph_of(char character);

}  // namespace velum
