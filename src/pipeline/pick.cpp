#include "pick.hpp"

#include "../base/contract.hpp"
#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "../image/visibility_buffer.hpp"
#include "../shading/line_view.hpp"
#include "../shading/triangle_view.hpp"
#include "check_request.hpp"
#include "line_stages.hpp"
#include "render.hpp"

namespace velum {
namespace {

Viewer viewer_of(const Camera& camera, const ViewingTransform& viewing, const RenderSettings& settings) {
  Viewer viewer;
  viewer.viewport = {settings.width, settings.height};
  viewer.eye = eye_of(viewing.clip_from_world());
  viewer.metric_depth_plane = metric_depth_plane(camera);
  return viewer;
}

PickResult result_at(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                     std::uint32_t primitive, float depth, int x, int y) {
  const ViewingTransform viewing = requested_view(camera, settings);
  const PrimitivePlace place = scene.place(primitive);
  const glm::dmat4 clip_from_object =
      viewing.clip_from_object(scene.instances()[place.instance].world_from_object);
  const Viewer viewer = viewer_of(camera, viewing, settings);
  PickResult result;
  SurfacePoint point;
  if (place.kind == PrimitiveKind::triangle) {
    const TriangleView view = view_triangle(scene, place, clip_from_object, viewer);
    point = surface_point(view, x, y, 1.0f - depth);
    result.barycentrics = barycentrics_at(view, x + 0.5, y + 0.5).clamped;
  } else {
    const bool x_major = is_x_major(scene, place, clip_from_object, viewer.viewport);
    const LineView view = view_line(scene, place, clip_from_object, viewer, x_major);
    point = surface_point(view, x, y, 1.0f - depth);
    const double t = parameter_at(view, x, y);
    result.barycentrics = {1.0 - t, t, 0.0};
  }
  result.object = place.instance;
  result.kind = place.kind;
  result.index = place.index;
  result.primitive = primitive;
  result.position = point.position;
  result.metric_depth = point.metric_depth;
  result.depth = depth;
  return result;
}

}  // namespace

std::optional<PickResult> pick(const Picture& picture, const Scene& scene, const Camera& camera,
                               const RenderSettings& settings, int x, int y) {
  const FloatingPointScope floating_point;
  const Rect rect = requested_rect(settings);
  check_pixel(rect, x, y);
  VELUM_REQUIRE(picture.triangle_id.width() == rect.width && picture.triangle_id.height() == rect.height,
                {"picture width", picture.triangle_id.width()}, {"settings' width", rect.width});
  const int column = x - rect.left;
  const int row = y - rect.top;
  const std::uint32_t primitive = picture.triangle_id.at(column, row);
  if (primitive == no_primitive) return std::nullopt;
  return result_at(scene, camera, settings, primitive, picture.depth.at(column, row), x, y);
}

std::optional<PickResult> pick(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                               int x, int y) {
  check_pixel(requested_rect(settings), x, y);
  RenderSettings one_pixel = settings;
  one_pixel.crop = Rect{x, y, 1, 1};
  one_pixel.shading = Shading::triangle_id;
  one_pixel.shader = nullptr;
  one_pixel.layers = 1;
  one_pixel.samples = one_pixel.supersample = 1;
  return pick(render(scene, camera, one_pixel), scene, camera, one_pixel, x, y);
}

glm::dvec3 unproject(const Camera& camera, const RenderSettings& settings, double px, double py, double z) {
  const FloatingPointScope floating_point;
  requested_rect(settings);
  const glm::dvec2 ndc = Viewport{settings.width, settings.height}.ndc_from_pixel(px, py);
  const glm::dvec4 world =
      requested_view(camera, settings).world_from_clip() * glm::dvec4(ndc.x, ndc.y, z, 1.0);
  const glm::dvec3 point = glm::dvec3(world) / world.w;
  const double sum = point.x + point.y + point.z;
  if (sum - sum != 0.0) {
    throw Error(ErrorKind::usage, "the point of this pixel and depth lies at infinity", "unproject",
                "give a depth that the camera maps from a finite distance");
  }
  return point;
}

Ray unproject_ray(const Camera& camera, const RenderSettings& settings, double px, double py) {
  const glm::dvec3 near = unproject(camera, settings, px, py, 0.0);
  return {near, unproject(camera, settings, px, py, 1.0) - near};
}

}  // namespace velum
