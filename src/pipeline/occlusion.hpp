#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "../base/aabb.hpp"
#include "../projection/camera.hpp"
#include "../raycast/intersection/sphere_intersection.hpp"
#include "../scene/scene.hpp"

namespace velum {

/// Answers what cannot be seen, before it is sent anywhere to be drawn: occluders are drawn once into a depth
/// buffer, then any number of boxes and balls are asked about (Greene, Kass & Miller 1993). What is
/// called hidden is hidden: no triangle within the box could show at any pixel centre of a picture of this
/// size. The converse does not hold: bounds are around boxes on the picture.
///
/// After construction it only reads: any number of threads may ask at once.
class OcclusionBuffer {
 public:
  /// Draws the occluders, as seen by the camera, both sides of their triangles; all of them are taken to be
  /// opaque, so leave out what is not.
  /// @param instances  the occluders among the scene's instances; empty: all
  /// @param width, height  of the buffer, pixels, 1 … 32768. Answers hold for pictures of this very size
  /// @throws Error (usage) for an instance that does not exist, a size or a camera that cannot be used
  OcclusionBuffer(const Scene& scene, const Camera& camera, int width, int height,
                  std::span<const std::uint32_t> instances = {});
  ~OcclusionBuffer();
  OcclusionBuffer(OcclusionBuffer&&) noexcept;
  OcclusionBuffer& operator=(OcclusionBuffer&&) noexcept;

  /// Whether nothing in the box (world space) can be seen: it is behind the occluders, or outside the view
  /// volume. An empty box is hidden; one that is not finite is not.
  bool is_hidden(const Aabb& box) const;
  /// The same for a ball: by the box around it.
  bool is_hidden(const Sphere& sphere) const;
  /// One answer per box, 1 for hidden.
  std::vector<std::uint8_t> are_hidden(std::span<const Aabb> boxes) const;

 private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

}  // namespace velum
