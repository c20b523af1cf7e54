#pragma once

#include <velum/velum.hpp>

/// What stands in the golden scenes: hard cases for the stages of the pipeline.
namespace golden {

/// Solids that overlap in the picture: one as it is, one skewed, one turned.
velum::Scene solids();
/// A plain F and three that are mirrored in x, in z, and in the point.
velum::Scene mirrored();
/// Three triangles and two solids that pass through each other.
velum::Scene interpenetrating();
/// The same surfaces twice, at the same place: the first must win at every pixel. And coplanar sheets.
velum::Scene ties();
/// A disc of 720 thin triangles, without a hole, and needles thinner than any pixel.
velum::Scene slivers();
/// Spheres whose triangles are smaller than a pixel.
velum::Scene sub_pixel();
/// Three sheets, each of two triangles of some 10⁴ pixels.
velum::Scene large();
/// A room around the solids.
velum::Scene room();
/// A surface with vertices that are NaN, infinite or huge, triangles without area, and a sound rest.
velum::Scene not_finite();
/// Translucent sheets that cross, around an opaque sphere and in a translucent cube.
velum::Scene transparent();
/// A checkerboard towards the horizon, and panels with a picture of odd size and transparent texels that is
/// repeated, clamped and mirrored.
velum::Scene textured();
/// A text file whose numbers are halfway cases and long digit strings: a reader that rounds wrongly, or heeds
/// the locale, gives another picture.
velum::Scene from_text();
/// Vertex colours, coloured lights, sharp highlights.
velum::Scene lit();
/// Solids among segments and points, with and without normals.
velum::Scene lines();
/// The solids, 10⁶ units from the origin.
velum::Scene far_away();
/// A row of stairs and letters, 2048 times as wide as it is high.
velum::Scene wide();

}  // namespace golden
