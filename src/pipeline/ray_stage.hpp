#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "../base/counters.hpp"
#include "../base/executor.hpp"
#include "../base/rect.hpp"
#include "../image/visibility_buffer.hpp"
#include "../projection/viewing_transform.hpp"
#include "../raycast/camera_rays.hpp"
#include "../raycast/scene_caster.hpp"
#include "../visibility/sample_positions.hpp"
#include "settings.hpp"

namespace velum {

/// What the stage keeps between frames.
struct RayStageBuffers {
  std::unique_ptr<SceneCaster> caster;  ///< of the scene that was rendered last
};

/// What the stage needs to know of the frame.
struct RayStageInput {
  const Scene& scene;
  const ViewingTransform& viewing;
  const RenderSettings& settings;
  Rect rect;
  Executor& executor;
  SamplePosition sample = pixel_centre;
};

/// A scene as the rays of one camera meet it.
class RayView {
 public:
  RayView(const Scene& scene, const SceneCaster& caster, const ViewingTransform& viewing,
          const RenderSettings& settings);

  /// The triangle that is seen at a place on the picture (pixels, y down), by geometry in the scene: of those
  /// that are not culled the first one between the near and the far plane.
  SceneHit at(double px, double py, CastCounters& counters) const;

  /// The same for many places at once. @param hits  as many as rays; see rays()
  void first_hits(std::span<const ViewRay> rays, std::span<SceneHit> hits, CastCounters& counters) const;

  /// The three corners in clip space, as the raster has them to the bit.
  std::array<glm::dvec4, 3> clip_triangle(std::uint32_t instance, std::uint32_t triangle) const;
  /// Whether a triangle is left out by the way it faces: the raster's own test.
  bool is_culled(std::uint32_t instance, std::uint32_t triangle) const;

  /// What is_culled() leaves of all hits; valid as long as this.
  SceneFilter filter() const;
  const CameraRays& rays() const { return rays_; }

 private:
  const Scene& scene_;
  const SceneCaster& caster_;
  Cull cull_;
  CameraRays rays_;
  std::vector<glm::dmat4> clip_from_object_;  ///< per instance
};

/// Visibility by ray casting: for each pixel one ray through its centre (or sample), from the inverse of the
/// composite viewing matrix. Which triangle is seen is found by geometry in the scene; its depth is that of
/// its plane at the pixel, the same float32 expression as in the raster, so equal ids have equal depth bits.
/// Segments and points, which have a width in pixels but no surface, are left to the raster.
///
/// Runs on disjoint rectangles of the picture; the same bytes at any number of threads.
/// @param progress  told the share of the picture that is done, 0…1, on the calling thread
/// @param buffer  cleared, of rect's size
void cast_visibility(const RayStageInput& input, const std::function<void(double)>& progress,
                     RayStageBuffers& buffers, VisibilityBuffer& buffer, Counters& counters);

}  // namespace velum
