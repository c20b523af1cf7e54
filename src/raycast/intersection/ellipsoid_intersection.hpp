#pragma once

#include <glm/mat4x4.hpp>

#include "../../base/ray.hpp"
#include "surface_hit.hpp"

namespace velum {

/// The unit sphere about the origin under an affine matrix.
struct Ellipsoid {
  glm::dmat4 world_from_unit{1.0};
};

/// The ray is taken to the unit sphere's space; affine maps keep t. Normals come back by the inverse
/// transpose. Nothing for a matrix that is singular.
SurfaceHits intersect(const Ray& ray, const Ellipsoid& ellipsoid);

/// The ray in another space. t keeps its meaning. @pre the matrix is affine
inline Ray transformed(const glm::dmat4& matrix, const Ray& ray) {
  return {glm::dvec3(matrix * glm::dvec4(ray.origin, 1.0)),
          glm::dvec3(matrix * glm::dvec4(ray.direction, 0.0))};
}

}  // namespace velum
