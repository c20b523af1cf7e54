#pragma once

#include <glm/vec3.hpp>

namespace velum {

/// The half-line origin + t·direction, t ≥ 0. The direction need not have length one.
struct Ray {
  glm::dvec3 origin{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};

  glm::dvec3 at(double t) const { return origin + direction * t; }
};

}  // namespace velum
