#pragma once

#include <vector>

#include "screen_triangle.hpp"

namespace velum {

/// The widest segment and the largest point, pixels; 1 is the least.
inline constexpr float widest_line = 256.0f;

/// Whether a segment's columns (else its rows) are counted: |Δx| ≥ |Δy|.
constexpr bool is_x_major(const SnappedVertex& a, const SnappedVertex& b) {
  const std::int32_t dx = a.x < b.x ? b.x - a.x : a.x - b.x;
  const std::int32_t dy = a.y < b.y ? b.y - a.y : a.y - b.y;
  return dx >= dy;
}

/// Appends a segment to what the raster draws, as the two halves of a parallelogram: an x-major segment is
/// `width` pixels tall in every column, a y-major one `width` wide in every row. That is OpenGL's rule for
/// wide aliased lines (The OpenGL Graphics System, version 4.6, 2022, §14.5.2.2, "Wide Lines"), here for
/// width 1 too, and with the top-left rule of triangles deciding the rest:
///
/// - a column (row) is drawn where its centre lies in [start, end) of the snapped ends, so the segments of a
///   polyline that runs one way draw every column once, joints included;
/// - each such column has exactly `width` pixels, if that is whole;
/// - swapping the ends changes nothing;
/// - a segment between two neighbouring centres, or without length on the picture, draws nothing.
///
/// OpenGL's one-pixel lines leave out the end whose diamond they do not leave (§14.5.1, the diamond-exit
/// rule, after Bresenham 1965, "Algorithm for computer control of a digital plotter"), which depends on the
/// direction; this rule differs from it in the columns of the two ends only.
///
/// @param prototype  depth and primitive id
/// @param width      pixels, 1 … widest_line
void append_segment(const SnappedVertex& a, const SnappedVertex& b, float width,
                    const ScreenTriangle& prototype, std::vector<ScreenTriangle>& out);

/// Appends a point: a square of `size` pixels centred at its snapped place (OpenGL 4.6 §14.4), exactly
/// size² pixels if that is whole.
void append_point(const SnappedVertex& centre, float size, const ScreenTriangle& prototype,
                  std::vector<ScreenTriangle>& out);

}  // namespace velum
