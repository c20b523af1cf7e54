#pragma once

#include <string>
#include <velum/velum.hpp>

namespace velum_app {

/// A triangle's way through every stage as a worked example: each line can be computed from those above it.
std::string triangle_text(const velum::TriangleTrace& trace, const velum::Scene& scene,
                          const velum::ViewingTransform& viewing, const velum::RenderSettings& settings);

}  // namespace velum_app
