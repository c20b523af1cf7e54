#pragma once

#include <string>
#include <velum/velum.hpp>

namespace velum_app {

/// A triangle's way through the six planes as a worked example: signed values, parameters and new vertices.
std::string clip_text(const velum::ClipTrace& trace);

}  // namespace velum_app
