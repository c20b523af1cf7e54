#pragma once

#include <glm/vec4.hpp>

namespace velum {

/// The colour of a wireframe's line over a pixel: black on light surfaces and where nothing opaque lies
/// below, white on dark ones.
/// @param below  what is there, linear, straight alpha
/// @return linear, opaque
glm::vec4 wireframe_ink(const glm::vec4& below);

}  // namespace velum
