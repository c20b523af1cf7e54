#pragma once

#include <velum/velum.hpp>

#include "json_values.hpp"

namespace velum_app {

/// What `--report` tells of a picture: {"size", "coverage", "bbox", "camera", "depth_resolution_at_far",
/// "counters", "stages", "sha256"}.
/// bbox is [x0, y0, x1, y1] in pixels of the written picture, the first two inclusive and the last two
/// exclusive; [0, 0, 0, 0] for a blank picture. Hashes: see sha256.hpp.
/// depth_resolution_at_far is the smallest step of depth that the depth format can tell at the far plane,
/// in world units (null: no far plane). All of it is the picture's: it is the same for
/// every visibility method.
Json report_of(const velum::Picture& picture, const velum::Camera& camera,
               const velum::RenderSettings& settings);

/// What the visibility method had to do for a picture, which differs between methods.
Json work_of(const velum::Counters& counters);

}  // namespace velum_app
