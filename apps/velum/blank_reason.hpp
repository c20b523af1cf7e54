#pragma once

#include <string>
#include <velum/velum.hpp>

namespace velum_app {

/// Why a picture shows nothing, as a sentence for a person, from what the pipeline counted.
/// @pre the picture's coverage is 0
std::string blank_reason(const velum::Counters& counters, const velum::Aabb& bounds,
                         const velum::Camera& camera, const velum::RenderSettings& settings);

}  // namespace velum_app
