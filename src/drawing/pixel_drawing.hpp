#pragma once

#include "../image/colour.hpp"
#include "../image/image.hpp"
#include "../pipeline/explain_pixel.hpp"

namespace velum {

/// How an explained pixel's neighbourhood is drawn.
struct PixelDrawing {
  int radius = 4;      ///< pixels shown to each side of the explained one, ≥ 0
  int cell_size = 64;  ///< the side of a pixel in the drawing, ≥ 8
};

/// Draws the pixels around an explained one: each tinted with the colour of the triangle that is seen there
/// (id_colour()), its centre a dot; over them the outlines of all pieces that cover the explained centre,
/// with their snapped corners, the seen one thick; below, the fragments with their depths in the order of
/// sight.
/// @pre `pixel` explains this scene, camera and settings
Image<Rgba8> draw_pixel(const PixelExplanation& pixel, const Scene& scene, const Camera& camera,
                        const RenderSettings& settings, const PixelDrawing& drawing = {});

}  // namespace velum
