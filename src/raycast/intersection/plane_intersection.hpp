#pragma once

#include <optional>

#include "../../base/plane.hpp"
#include "../../base/ray.hpp"
#include "surface_hit.hpp"

namespace velum {

/// A finite piece of a plane: corner + a·u + b·v with 0 ≤ a, b ≤ 1.
struct Rectangle {
  glm::dvec3 corner{0.0};
  glm::dvec3 u{1.0, 0.0, 0.0};
  glm::dvec3 v{0.0, 1.0, 0.0};
};

/// Where the line of a ray meets an infinite plane. Nothing for a ray along the plane, also one inside it:
/// there is no one point then.
std::optional<SurfaceHit> intersect(const Ray& ray, const Plane& plane);

/// The same for a rectangle (any parallelogram), its boundary included; the normal is u × v.
std::optional<SurfaceHit> intersect(const Ray& ray, const Rectangle& rectangle);

}  // namespace velum
