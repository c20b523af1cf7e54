#pragma once

#include <string>
#include <velum/velum.hpp>

namespace velum_app {

/// All fragments at a pixel's centre with their edge values and depths, nearest first, and who is seen and
/// why.
std::string fragments_text(const velum::PixelExplanation& pixel, const velum::Scene& scene);

}  // namespace velum_app
