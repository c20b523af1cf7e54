#pragma once

#include "../scene/scene.hpp"
#include "shading.hpp"

namespace velum {

/// lighting_of() into a Lighting whose memory is kept.
void light_scene(const Scene& scene, const glm::dvec3& to_viewer, Lighting& lighting);

}  // namespace velum
