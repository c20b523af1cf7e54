#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "raster_target.hpp"
#include "screen_triangle.hpp"
#include "z_interpolation.hpp"

namespace velum {

/// An edge of a triangle as the scanline method walks it: from row to row by additions, exactly.
///
/// It is active on the rows whose centres y lie in [upper end, lower end). On each it has n, the first pixel
/// whose centre is at or right of the exact crossing; `excess` is how far right, in 1/denominator pixel. A
/// span from one edge's n up to, not including, the other's is the top-left rule.
struct ScanlineEdge {
  std::uint32_t triangle = 0;  ///< index among the triangles
  std::int32_t row = 0;        ///< the row for which n and excess stand
  std::int32_t end_row = 0;    ///< one past the last active row
  std::int32_t n = 0;
  std::int32_t step = 0;            ///< whole pixels per row, rounded down …
  std::int64_t step_remainder = 0;  ///< … and what is left, in 1/denominator pixel
  std::int64_t excess = 0;          ///< in [0, denominator)
  std::int64_t denominator = 1;
};

/// The memory of the scanline method; hand in the same again to save allocations.
struct ScanlineTables {
  std::vector<ScanlineEdge> unsorted;
  std::vector<ScanlineEdge> edge_table;          ///< by first row, then by triangle
  std::vector<std::uint32_t> first_edge_of_row;  ///< where each row's bucket begins; one more at the end
  std::vector<ScanlineEdge> active;              ///< sorted by triangle: each has two or none
  std::vector<ScanlineEdge> merged;
};

/// The scanline method: rows from top to bottom, an edge table by first row, an active edge list, spans
/// between pairs of active edges (Wylie, Romney, Evans & Erdahl 1967, "Half-tone perspective drawings by
/// computer"; Bouknight 1970, "A procedure for generation of three-dimensional half-toned computer graphics
/// presentations"; Foley, van Dam, Feiner & Hughes 1990, §3.6 and §15.6). Where they sort spans by depth, the
/// buffer's row over (depth, id) decides here, so triangles may come in several calls and in any order.
///
/// With ZInterpolation::plane the buffer is that of rasterize_zbuffer, to the bit.
/// @pre target.buffer has target.rect's size, unless there are target.lists; coordinates are within ±2²³
RasterCounts rasterize_scanline(std::span<const ScreenTriangle> triangles, const RasterTarget& target,
                                ZInterpolation z_interpolation, ScanlineTables& tables);

/// The same with tables of its own.
RasterCounts rasterize_scanline(std::span<const ScreenTriangle> triangles, const RasterTarget& target,
                                ZInterpolation z_interpolation = ZInterpolation::plane);

}  // namespace velum
