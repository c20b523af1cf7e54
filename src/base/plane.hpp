#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace velum {

/// The plane normal·x + offset = 0; its positive half-space is the side the normal points to.
/// The normal need not have length one: signed_value() is a distance only when it has.
struct Plane {
  glm::dvec3 normal{0.0, 0.0, 1.0};
  double offset = 0.0;

  /// The plane through a, b, c whose normal sees them counter-clockwise; length = twice the triangle's area.
  static Plane through(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    return {normal, -glm::dot(normal, a)};
  }

  glm::dvec4 homogeneous() const { return {normal, offset}; }
  double signed_value(const glm::dvec3& point) const { return glm::dot(normal, point) + offset; }
};

}  // namespace velum
