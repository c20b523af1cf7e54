#include <limits>

#include "../shading/shade.hpp"
#include "../shading/wireframe.hpp"
#include "stages.hpp"

namespace velum {
namespace {

bool is_finite(double v) {
  return v - v == 0.0;
}

/// The world point in the middle of the picture at canonical depth z.
glm::dvec3 middle_at(const glm::dmat4& world_from_clip, double z) {
  const glm::dvec4 point = world_from_clip * glm::dvec4(0.0, 0.0, z, 1.0);
  return glm::dvec3(point) / point.w;
}

/// The depths that the depth view spreads its greys over: the camera's, not the visible surface's, so that a
/// crop equals the same part of the whole picture.
MetricRange depth_view_range(const glm::dmat4& world_from_clip, const glm::dvec4& depth_plane) {
  const auto depth_at = [&](double z) {
    return glm::dot(depth_plane, glm::dvec4(middle_at(world_from_clip, z), 1.0));
  };
  const MetricRange range{depth_at(0.0), depth_at(1.0)};
  return is_finite(range.nearest) && is_finite(range.farthest) ? range : MetricRange{};
}

/// A visible triangle as the shading needs it; kept while neighbouring pixels show the same one.
struct VisibleTriangle {
  std::uint32_t primitive = no_primitive;
  TriangleView view;
  LitTriangle lit;
};

class ShadeStage {
 public:
  ShadeStage(const ShadeInput& input, const PictureTarget& target) : input_(input), target_(target) {
    const glm::dmat4 world_from_clip = input.viewing.world_from_clip();
    viewer_.viewport = {input.settings.width, input.settings.height};
    viewer_.eye = eye_of(input.viewing.clip_from_world());
    viewer_.metric_depth_plane = metric_depth_plane(input.camera);
    range_ = depth_view_range(world_from_clip, viewer_.metric_depth_plane);
    lighting_ = lighting_of(input.scene, to_viewer_from(middle_at(world_from_clip, 0.5), viewer_.eye));
    for (const Instance& instance : input.scene.instances()) {
      clip_from_object_.push_back(input.viewing.clip_from_object(instance.world_from_object));
    }
  }

  /// @param x, y  in the buffer
  void shade_pixel(int x, int y, std::uint32_t primitive, float reversed_depth) {
    if (triangle_.primitive != primitive) set_triangle(primitive);
    const SurfacePoint point =
        surface_point(triangle_.view, x + input_.rect.left, y + input_.rect.top, reversed_depth);
    if (target_.colour.data) target_.colour.at(x, y) = srgb_from_linear(colour_of(point));
    if (target_.depth.data) target_.depth.at(x, y) = point.depth;
    if (target_.metric_depth.data) target_.metric_depth.at(x, y) = static_cast<float>(point.metric_depth);
    if (target_.normal.data) target_.normal.at(x, y) = point.shading_normal;
    if (target_.object_id.data) target_.object_id.at(x, y) = point.object;
    if (target_.triangle_id.data) target_.triangle_id.at(x, y) = primitive;
  }

  void write_background(int x, int y) {
    if (target_.colour.data) target_.colour.at(x, y) = input_.settings.background;
    if (target_.depth.data) target_.depth.at(x, y) = 1.0f;
    if (target_.metric_depth.data) target_.metric_depth.at(x, y) = std::numeric_limits<float>::infinity();
    if (target_.normal.data) target_.normal.at(x, y) = glm::vec3(0.0f);
    if (target_.object_id.data) target_.object_id.at(x, y) = no_primitive;
    if (target_.triangle_id.data) target_.triangle_id.at(x, y) = no_primitive;
  }

 private:
  void set_triangle(std::uint32_t primitive) {
    const PrimitivePlace place = input_.scene.place(primitive);
    triangle_.primitive = primitive;
    triangle_.view = view_triangle(input_.scene, place, clip_from_object_[place.instance], viewer_);
    triangle_.lit = light_triangle(input_.settings.shading, lighting_, triangle_.view);
  }

  glm::vec4 colour_of(const SurfacePoint& point) const {
    const RenderSettings& settings = input_.settings;
    const glm::vec4 colour = settings.shader
                                 ? settings.shader(point)
                                 : shade(settings.shading, lighting_, triangle_.lit, point, range_);
    if (!settings.wireframe) return colour;
    return over_wireframe(colour, edge_distance(triangle_.view, point.x + 0.5, point.y + 0.5));
  }

  const ShadeInput& input_;
  const PictureTarget& target_;
  Viewer viewer_;
  MetricRange range_;
  Lighting lighting_;
  std::vector<glm::dmat4> clip_from_object_;
  VisibleTriangle triangle_;
};

}  // namespace

void shade_visible(const ShadeInput& input, const VisibilityBuffer& buffer, const PictureTarget& target,
                   Counters& counters) {
  ShadeStage stage(input, target);
  for (int y = 0; y < buffer.height(); ++y) {
    const std::uint32_t* const ids = buffer.primitive.row(y);
    const float* const depths = buffer.reversed_depth.row(y);
    for (int x = 0; x < buffer.width(); ++x) {
      if (ids[x] == no_primitive) {
        stage.write_background(x, y);
      } else {
        stage.shade_pixel(x, y, ids[x], depths[x]);
        ++counters.pixels_shaded;
      }
    }
  }
}

}  // namespace velum
