#pragma once

#include <velum/velum.hpp>

#include "json_values.hpp"

namespace velum_app {

/// What `--report` tells of a picture: {"size", "coverage", "bbox", "camera", "counters", "stages",
/// "sha256"}.
/// bbox is [x0, y0, x1, y1] in pixels of the written picture, the first two inclusive and the last two
/// exclusive; [0, 0, 0, 0] for a blank picture. Hashes: see sha256.hpp.
Json report_of(const velum::Picture& picture, const velum::Camera& camera, double aspect);

}  // namespace velum_app
