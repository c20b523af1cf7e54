#pragma once

#include <glm/vec3.hpp>

namespace velum {

/// Light from infinitely far away.
struct DirectionalLight {
  glm::dvec3 direction{0.0, -1.0, 0.0};  ///< the way the light travels, world space; need not be unit length
  glm::vec3 radiance{1.0f};              ///< linear
};

/// Light from a point; no falloff with distance, as in the lecture's local lighting model.
struct PointLight {
  glm::dvec3 position{0.0};  ///< world space
  glm::vec3 radiance{1.0f};  ///< linear
};

}  // namespace velum
