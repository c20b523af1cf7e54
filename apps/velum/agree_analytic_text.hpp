#pragma once

#include <string>
#include <velum/velum.hpp>

#include "camera_options.hpp"

namespace velum_app {

/// velum agree builtin:NAME --analytic: the triangles of a built-in shape against its equation, at the
/// default tessellation, twice and four times as fine. Prints a line for each, or JSON.
/// @return the exit code: whether every difference is explained
/// @throws velum::Error (usage) for what has no equation
int agree_with_equation(const std::string& input, const View& view, const velum::RenderSettings& settings,
                        bool json);

}  // namespace velum_app
