#pragma once

// Measures of a sheet that its layout and its drawing share; pixels.

namespace velum {

inline constexpr int sheet_margin = 12;  ///< free on each side of a view
inline constexpr int label_height = 22;  ///< below each view, for its name
inline constexpr int sheet_footer = 26;  ///< below all views, for angle and scale

}  // namespace velum
