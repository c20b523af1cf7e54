#pragma once

#include <span>

#include "../projection/camera.hpp"
#include "analytic_view.hpp"
#include "picture.hpp"
#include "settings.hpp"

namespace velum {

/// Renders bodies by their equations instead of triangles: one ray through each pixel's centre. All outputs
/// are those of the body: place, depth and normal have no facets. A body has no triangles, so `triangle_id`
/// has the first primitive of its instance. Of several bodies the nearest is seen, over the background; what
/// lies behind a translucent one is not.
///
/// The same bytes at any number of threads and on every machine. agree_analytic() holds the ids of objects
/// against those of the raster.
/// @param bodies  of each instance. @pre as many as instances
/// @param settings  shading phong, normal, depth or object_id, or a shader of one's own (its point has no
/// texture and no barycentric coordinates); size, crop, background, culling, threads, memory and progress as
/// in render()
/// @throws Error (usage) for what needs triangles: other shadings, wireframe, several samples, supersampling;
/// and as render()
Picture render_analytic(const Scene& scene, std::span<const AnalyticBody> bodies, const Camera& camera,
                        const RenderSettings& settings);

}  // namespace velum
