#include "crop_rejection.hpp"

#include <algorithm>

#include "../visibility/box_projection.hpp"

namespace velum {
namespace {

/// How far the pixels of lines, and samples beside a pixel's centre, reach beyond a mesh's box; rounded up.
int reach_of(const Mesh& mesh, const RenderSettings& settings) {
  constexpr int samples = 1;
  if (mesh.segments.empty() && mesh.points.empty()) return samples;
  return samples + static_cast<int>(0.5f * std::max(settings.line_width, settings.point_size)) + 1;
}

}  // namespace

bool is_beside(const Scene& scene, std::uint32_t instance, const glm::dmat4& clip_from_object,
               const RenderSettings& settings, const Rect& rect) {
  if (rect == Rect{0, 0, settings.width, settings.height}) return false;
  const std::uint32_t mesh = scene.instances()[instance].mesh;
  const Aabb& box = scene.mesh_bounds(mesh);
  if (box.is_empty()) return false;
  const Viewport viewport{settings.width, settings.height};
  const BoxOnPicture seen = BoxProjection(clip_from_object, viewport, box)(box);
  if (seen.is_outside) return true;
  const int reach = reach_of(scene.meshes()[mesh], settings);
  const Rect grown{seen.pixels.left - reach, seen.pixels.top - reach, seen.pixels.width + 2 * reach,
                   seen.pixels.height + 2 * reach};
  return intersect(grown, rect).is_empty();
}

}  // namespace velum
