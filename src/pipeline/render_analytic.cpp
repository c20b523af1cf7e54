#include "render_analytic.hpp"

#include <algorithm>

#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "../image/visibility_buffer.hpp"
#include "../shading/shade.hpp"
#include "check_request.hpp"
#include "frame.hpp"
#include "layer_blend.hpp"
#include "memory_need.hpp"
#include "pixel_shader.hpp"

namespace velum {
namespace {

void check_has_no_triangles(const RenderSettings& settings) {
  const auto refuse = [](const char* problem, const char* where, const char* advice) {
    throw Error(ErrorKind::usage, problem, where, advice);
  };
  const Shading shading = settings.shading;
  const bool is_of_points = shading == Shading::phong || shading == Shading::normal ||
                            shading == Shading::depth || shading == Shading::object_id;
  if (!is_of_points && !settings.has_custom_shader()) {
    refuse("a body seen by its equation has no triangles to shade", "shading",
           "choose phong, normal, depth or object-id");
  }
  if (settings.wireframe) {
    refuse("a body seen by its equation has no edges", "wireframe", "leave it out, or trace triangles");
  }
  if (settings.samples != 1 || settings.supersample != 1) {
    refuse("bodies are seen by one ray a pixel", "samples", "leave out samples and supersampling");
  }
}

/// Shades bodies pixel by pixel.
class AnalyticPixels {
 public:
  AnalyticPixels(const ShadeInput& input, std::span<const AnalyticBody> bodies)
      : context_(input),
        view_(input.scene, bodies, input.settings.cull),
        rays_(input.viewing, {input.settings.width, input.settings.height}),
        clip_from_world_(input.viewing.clip_from_world()),
        background_(linear_from_srgb(input.settings.background)) {}

  /// @param row  of the rectangle. @return how many pixels show a body
  std::uint64_t shade_row(int row, Picture& picture) const {
    const Rect& rect = context_.input.rect;
    std::uint64_t shaded = 0;
    for (int column = 0; column < rect.width; ++column) {
      const int x = rect.left + column, y = rect.top + row;
      const ViewRay view = rays_.through(x + 0.5, y + 0.5);
      const std::optional<AnalyticHit> hit = view_.first_hit(view);
      if (!hit) {
        write_background(column, row, picture);
        continue;
      }
      write(point_at(*hit, view.ray, x, y), column, row, picture);
      ++shaded;
    }
    return shaded;
  }

 private:
  SurfacePoint point_at(const AnalyticHit& hit, const Ray& ray, int x, int y) const {
    const Scene& scene = context_.input.scene;
    SurfacePoint point;
    point.position = ray.at(hit.t);
    point.to_viewer = to_viewer_from(point.position, context_.viewer.eye);
    point.geometric_normal = glm::vec3(hit.back_facing ? -hit.normal : hit.normal);
    point.shading_normal = point.geometric_normal;
    point.metric_depth = glm::dot(context_.viewer.metric_depth_plane, glm::dvec4(point.position, 1.0));
    point.depth = canonical_depth(point.position);
    point.object = hit.object;
    point.primitive = scene.first_primitive(hit.object);
    point.back_facing = hit.back_facing;
    point.x = x;
    point.y = y;
    point.material = &scene.materials()[scene.instances()[hit.object].material];
    point.colour = {point.material->base_colour, point.material->alpha};
    return point;
  }

  /// By way of the reversed depth, as the raster's: 1 - z is formed before rounding.
  float canonical_depth(const glm::dvec3& position) const {
    const glm::dvec4 clip = clip_from_world_ * glm::dvec4(position, 1.0);
    const auto reversed = static_cast<float>((clip.w - clip.z) / clip.w);
    return 1.0f - std::clamp(reversed, 0.0f, 1.0f);
  }

  glm::vec4 colour_of(const SurfacePoint& point) const {
    const RenderSettings& settings = context_.input.settings;
    if (settings.inlined_shader) {
      glm::vec4 colour;
      settings.inlined_shader(&point, 1, &colour);
      return colour;
    }
    if (settings.shader) return settings.shader(point);
    return shade(settings.shading, context_.lighting, LitTriangle{}, point, context_.range);
  }

  void write(const SurfacePoint& point, int column, int row, Picture& picture) const {
    const glm::vec4 colour = colour_of(point);
    glm::vec4 front(0.0f);
    const bool is_translucent = add_behind(colour, front);
    picture.colour.at(column, row) =
        is_translucent ? over_background(front, background_) : srgb_from_linear(colour);
    picture.depth.at(column, row) = point.depth;
    picture.metric_depth.at(column, row) = static_cast<float>(point.metric_depth);
    picture.normal.at(column, row) = point.shading_normal;
    picture.object_id.at(column, row) = point.object;
    picture.triangle_id.at(column, row) = point.primitive;
  }

  void write_background(int column, int row, Picture& picture) const {
    picture.colour.at(column, row) = context_.input.settings.background;
    picture.depth.at(column, row) = 1.0f;
    picture.metric_depth.at(column, row) = std::numeric_limits<float>::infinity();
    picture.normal.at(column, row) = glm::vec3(0.0f);
    picture.object_id.at(column, row) = picture.triangle_id.at(column, row) = no_primitive;
  }

  const ShadeContext context_;
  const AnalyticView view_;
  const CameraRays rays_;
  const glm::dmat4 clip_from_world_;
  const glm::vec4 background_;
};

}  // namespace

Picture render_analytic(const Scene& scene, std::span<const AnalyticBody> bodies, const Camera& camera,
                        const RenderSettings& settings) {
  const FloatingPointScope floating_point;
  const Rect rect = requested_rect(settings);
  check_machine(settings);
  check_has_no_triangles(settings);
  const ViewingTransform viewing = requested_view(camera, settings);
  memory_left(picture_bytes(rect), settings);
  // A shader of one's own that is not inlined is called on the calling thread only.
  const bool is_alone = settings.shader && !settings.inlined_shader;
  Executor executor(is_alone ? 1 : settings.threads, settings.executor);
  Picture picture;
  picture.resize(rect.width, rect.height);
  const AnalyticPixels pixels({scene, camera, viewing, settings, rect, executor}, bodies);
  picture.counters.instances = scene.instances().size();
  picture.counters.rays = static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height);
  constexpr int band = 32;
  std::vector<std::uint64_t> shaded(static_cast<std::size_t>(executor.threads()));
  for (int top = 0; top < rect.height; top += band) {
    const int rows = std::min(band, rect.height - top);
    executor.for_each(static_cast<std::size_t>(rows), [&](std::size_t row, int worker) {
      shaded[static_cast<std::size_t>(worker)] += pixels.shade_row(top + static_cast<int>(row), picture);
    });
    report_progress(settings, static_cast<double>(top + rows) / rect.height);
  }
  for (const std::uint64_t count : shaded) picture.counters.pixels_shaded += count;
  return picture;
}

}  // namespace velum
