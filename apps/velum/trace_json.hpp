#pragma once

#include <velum/velum.hpp>

#include "json_values.hpp"

namespace velum_app {

/// Names of the planes in an outcode: ["in front", "left"].
Json planes_json(velum::Outcode code);
/// What `velum pixel --json` tells.
Json json_of(const velum::PixelExplanation& pixel);
Json json_of(const velum::TriangleTrace& trace);
/// What `velum clip-trace --json` tells.
Json json_of(const velum::ClipTrace& trace);

}  // namespace velum_app
