#pragma once

#include "scene.hpp"

namespace velum {

/// Makes the default material white, so that colours a file gives its vertices show as they are, not
/// multiplied by the grey of surfaces that have none.
inline void show_vertex_colours(Scene& scene) {
  Material white = scene.materials()[0];
  white.base_colour = glm::vec3(1.0f);
  scene.set_material(0, white);
}

}  // namespace velum
