#pragma once

#include <limits>

#include "../image/colour.hpp"
#include "../image/image.hpp"
#include "../pipeline/explain_ray.hpp"
#include "../scene/scene.hpp"

namespace velum {

/// What a drawing of a ray's way shows.
struct RayDrawing {
  int levels = 3;                               ///< of boxes below the outermost one of a panel, ≥ 1
  int depth = std::numeric_limits<int>::max();  ///< steps of deeper levels are left out
  int most_panels = 12;                         ///< ≥ 1; what leads to the hit is kept longest
};

/// Draws a ray's way through the boxes from the side, in panels that go deeper and deeper: each has one box
/// that was entered, what was looked at inside it, and a list of the steps with their numbers, which are
/// their places in `ray.traversal`. Entered boxes are green, missed ones grey, those left out because a
/// nearer hit is known orange. Behind lies the part of the scene that is inside the panel's box, faintly.
/// @param scene  the one that was explained
/// @throws Error as render()
Image<Rgba8> draw_ray(const Scene& scene, const RayExplanation& ray, const RayDrawing& drawing = {});

}  // namespace velum
