#pragma once

#include "../image/colour.hpp"
#include "../image/image.hpp"
#include "../pipeline/clip_trace.hpp"

namespace velum {

/// Draws a triangle's way through the six planes: the canonical view volume as a wire box seen from outside
/// (its near face to the front left, axonometric), one panel for the triangle and one for each plane that
/// cuts, with that plane's face shaded. Vertices are numbered as in the trace; those a plane cut off are
/// hollow, those it made are filled. Vertices with w ≤ 0 lie behind the eye and have no place in the volume:
/// the outline is then drawn as far as it lies in front of the eye, and the panel says so.
/// @param panel_size  side of a panel in pixels, 120 … 2000
Image<Rgba8> draw_clipping(const ClipTrace& trace, int panel_size = 440);

}  // namespace velum
