#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "../base/ray.hpp"
#include "../projection/camera.hpp"
#include "../scene/scene.hpp"
#include "picture.hpp"
#include "settings.hpp"

namespace velum {

/// What is seen at a pixel's centre.
struct PickResult {
  std::uint32_t object = 0;  ///< instance
  PrimitiveKind kind = PrimitiveKind::triangle;
  std::uint32_t index = 0;       ///< among the triangles, segments or points of the instance's mesh
  std::uint32_t primitive = 0;   ///< in the scene
  glm::dvec3 barycentrics{0.0};  ///< perspective-correct, of the primitive's vertices; ≥ 0, sum 1
  glm::dvec3 position{0.0};      ///< world space, on the primitive
  double metric_depth = 0.0;     ///< distance from the camera plane along the look vector, world units
  float depth = 1.0f;            ///< canonical, as Picture::depth
};

/// What a rendered picture shows at pixel (x, y) of the whole picture (y down); nothing on the background.
/// @pre the picture was rendered from this scene and camera with these settings
/// @throws Error (usage) for a pixel outside the picture (or its crop)
std::optional<PickResult> pick(const Picture& picture, const Scene& scene, const Camera& camera,
                               const RenderSettings& settings, int x, int y);

/// The same without a picture: renders that one pixel.
std::optional<PickResult> pick(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                               int x, int y);

/// The world point whose image is (px, py) at canonical depth z.
/// @param px,py  pixels of the whole picture, y down; a pixel's centre lies at +0.5; may lie outside
/// @param z      canonical: 0 on the near plane, 1 on the far plane
/// @throws Error (usage) if the viewing transform is singular, or the point lies at infinity
glm::dvec3 unproject(const Camera& camera, const RenderSettings& settings, double px, double py, double z);

/// The projector through (px, py): from the near plane to the far plane, t running from 0 to 1 between them.
/// It is the line of all world points with this image. @throws Error (usage) as unproject
Ray unproject_ray(const Camera& camera, const RenderSettings& settings, double px, double py);

}  // namespace velum
