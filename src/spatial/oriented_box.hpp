#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace velum {

/// A box that need not be parallel to the axes: a corner, and the three edges from there.
struct OrientedBox {
  glm::dvec3 corner{0.0};
  glm::dvec3 x{0.0}, y{0.0}, z{0.0};
};

/// A box around points that lies flat on the surface they belong to.
/// @param points  finite, at least one
/// @param normal  the box's z axis, unit length; (0, 0, 0): boxes parallel to the axes
OrientedBox oriented_box(std::span<const glm::vec3> points, const glm::dvec3& normal);

}  // namespace velum
