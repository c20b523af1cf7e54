#include "blank_reason.hpp"

#include <glm/geometric.hpp>

#include "text.hpp"

namespace velum_app {
namespace {

using namespace velum;

bool is_behind_camera(const Aabb& bounds, const Camera& camera) {
  const glm::dvec4 plane = metric_depth_plane(camera);
  for (const glm::dvec3& corner : bounds.corners()) {
    if (glm::dot(plane, glm::dvec4(corner, 1.0)) > 0.0) return false;
  }
  return true;
}

/// Where triangles are that lie outside plane i.
std::string place_of(int plane, const Aabb& bounds, const Camera& camera) {
  switch (static_cast<ClipPlane>(plane)) {
    case ClipPlane::front:
      return is_behind_camera(bounds, camera)
                 ? "behind the camera (in front of the near plane)"
                 : "in front of the near plane (nearer than " + number_text(camera.near()) + ")";
    case ClipPlane::behind:
      return "behind the far plane (farther than " + number_text(camera.far()) + ")";
    case ClipPlane::left:
      return "to the left of the picture";
    case ClipPlane::right:
      return "to the right of the picture";
    case ClipPlane::below:
      return "below the picture";
    case ClipPlane::above:
      return "above the picture";
  }
  return "outside the picture";
}

std::string all_lie(std::uint64_t count) {
  return count == 1 ? "the only triangle lies " : "all " + counted_text(count, "triangle") + " lie ";
}

/// "of the 12 triangles 7 lie behind the camera …, 5 to the right of the picture"
std::string scattered(const Counters& counters, const Aabb& bounds, const Camera& camera) {
  std::string text;
  for (int plane = 0; plane < clip_plane_count; ++plane) {
    const std::uint64_t count = counters.outside[plane];
    if (count == 0) continue;
    text += (text.empty() ? "" : ", ") + grouped_text(count) + " lie " + place_of(plane, bounds, camera);
  }
  return text.empty() ? text : "of the " + counted_text(counters.triangles, "triangle") + ", " + text;
}

constexpr const char* beside_crop = "nothing of the scene lies in the part of the picture that --crop chose";

}  // namespace

std::string blank_reason(const Counters& counters, const Aabb& bounds, const Camera& camera,
                         const RenderSettings& settings) {
  if (counters.instances == 0 && counters.instances_beside > 0) return beside_crop;
  if (counters.triangles == 0) {
    if (counters.segments + counters.points == 0) return "the scene has no triangles, segments or points";
    if (counters.screen_triangles == 0) return "all segments and points lie outside the view volume";
    if (settings.crop) return beside_crop;
    return "no segment or point covers a pixel centre";
  }
  if (counters.not_finite == counters.triangles) return "every triangle has a vertex that is not finite";
  if (counters.culled == counters.triangles) {
    return "all " + counted_text(counters.triangles, "triangle") + " face away and were removed by --cull";
  }
  const std::uint64_t candidates = counters.triangles - counters.culled - counters.not_finite;
  for (int plane = 0; plane < clip_plane_count; ++plane) {
    if (counters.outside[plane] == candidates) return all_lie(candidates) + place_of(plane, bounds, camera);
  }
  if (counters.screen_triangles == 0) {
    const std::string places = scattered(counters, bounds, camera);
    return places.empty() ? "all triangles lie outside the view volume" : places;
  }
  if (settings.crop) return beside_crop;
  return "no triangle covers a pixel centre: the scene is seen edge-on or too small in the picture";
}

}  // namespace velum_app
