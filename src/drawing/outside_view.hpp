#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "../base/aabb.hpp"
#include "../projection/camera.hpp"

namespace velum {

/// A camera's view volume as far as it matters beside a scene; world space.
struct ShownVolume {
  /// Numbered as Aabb::corners() numbers them: x to the right, y up, z from the near plane away.
  std::array<glm::dvec3, 8> corners;
  bool is_cut = false;            ///< the far plane is well behind the scene: the corners are where that ends
  std::optional<glm::dvec3> eye;  ///< none for parallel projections

  /// Where the edge from near corner `i` would go on to, a little beyond the cut. @pre 0 ≤ i < 4
  glm::dvec3 beyond(std::size_t i) const { return corners[i + 4] + (corners[i + 4] - corners[i]) * 0.08; }
};

/// None if a corner is not finite, as of cameras whose far plane is at infinity.
std::optional<ShownVolume> shown_volume(const ViewingTransform& viewing, const Aabb& scene);

/// Looks at the scene and the volume from beside the first camera, a little from above and behind; both fit,
/// with room for `margin` of the picture at each side.
/// @param up  the world's
Camera outside_camera(const Aabb& scene, const std::optional<ShownVolume>& volume, const glm::dvec3& up,
                      double aspect, double margin = 0.04);

}  // namespace velum
