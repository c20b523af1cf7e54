#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace velum {

bool is_finite(const glm::dvec3& v);

/// The vector with length 1; scaled first, so that no square over- or underflows.
/// Precondition: finite and not zero.
glm::dvec3 unit(const glm::dvec3& v);

/// Whether the two directions lie on one line: |sin| of their angle ≤ 1e-9. Zero is parallel to everything.
bool are_parallel(const glm::dvec3& a, const glm::dvec3& b);

/// The camera's right, up and back in world space: orthonormal, right-handed, the columns of M_rot.
struct CameraAxes {
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  glm::dvec3 back{0.0, 0.0, 1.0};

  glm::dvec3 camera_from_world(const glm::dvec3& direction) const {
    return {glm::dot(right, direction), glm::dot(up, direction), glm::dot(back, direction)};
  }
  glm::dvec3 world_from_camera(const glm::dvec3& direction) const {
    return right * direction.x + up * direction.y + back * direction.z;
  }
};

/// @throws Error (usage) if look or up is zero or not finite, or if they are parallel
CameraAxes camera_axes(const glm::dvec3& look, const glm::dvec3& up);

}  // namespace velum
