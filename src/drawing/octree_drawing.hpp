#pragma once

#include "../image/colour.hpp"
#include "../image/image.hpp"
#include "../pipeline/settings.hpp"
#include "../projection/camera.hpp"
#include "../scene/scene.hpp"

namespace velum {

/// Draws, from a second camera outside, what the hierarchical method did with each octree node it decided
/// about: drawn (green), beyond the view volume (grey), hidden by the z-pyramid (red), facing away (orange);
/// with the view volume's edges (blue), cut off (dashed) behind the scene where the far plane is much
/// farther, the eye, and, unless the picture is too small for it, how many of each there were. The second
/// camera stands beside the first and sees all of this.
/// @param settings  of the picture that `camera` takes; for its size, culling and hierarchy
/// @param width, height  of the drawing, pixels
/// @throws Error as render()
Image<Rgba8> draw_octree(const Scene& scene, const Camera& camera, const RenderSettings& settings, int width,
                         int height);

}  // namespace velum
