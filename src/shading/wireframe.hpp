#pragma once

#include <glm/vec4.hpp>

#include "../image/colour.hpp"
#include "../scene/scene.hpp"

namespace velum {

/// The one colour of all lines of a picture's wireframe: of black, white and a red between them the one that
/// stands out most from what it resembles most among the background, unless it is transparent, and the
/// scene's materials; of a texture its darkest and its lightest parts count. (One colour, since a line whose
/// colour follows what lies below falls to pieces along every silhouette.)
/// @return linear, opaque
glm::vec4 wireframe_ink(const Scene& scene, const Rgba8& background);

}  // namespace velum
