#pragma once

#include <vector>

#include "../image/colour.hpp"
#include "../image/image.hpp"
#include "../visibility/z_pyramid.hpp"

namespace velum {

/// Draws every level of a z-pyramid at the size of level 0, so that its blocks are seen: near is light, far
/// is dark, and blocks with background in them, behind which nothing can be hidden, are blue.
std::vector<Image<Rgba8>> draw_pyramid_levels(const ZPyramid& pyramid);

/// The share of the picture, 0 … 1, in those cells of a level that hold no background: only behind these can
/// the level hide anything. @pre 0 ≤ level < pyramid.levels()
double share_that_hides(const ZPyramid& pyramid, int level);

/// The levels side by side, each under its number, its size and how much of it can hide something.
/// @param columns  ≥ 1
Image<Rgba8> draw_pyramid_sheet(const ZPyramid& pyramid, int columns = 4);

}  // namespace velum
