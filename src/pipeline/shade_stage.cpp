#include "shade_stage.hpp"

#include <algorithm>
#include <limits>

#include "../shading/wireframe.hpp"
#include "line_stages.hpp"
#include "wireframe_stage.hpp"

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

}  // namespace

ShadeStage::ShadeStage(const ShadeInput& input, const PictureTarget& target, LayerBuffers& layers)
    : input_(input), target_(target), layers_(layers) {
  const glm::dmat4 world_from_clip = input.viewing.world_from_clip();
  viewer_.viewport = {input.settings.width, input.settings.height};
  viewer_.eye = eye_of(input.viewing.clip_from_world());
  viewer_.metric_depth_plane = metric_depth_plane(input.camera);
  viewer_.texture_filter = input.settings.texture_filter;
  range_ = depth_view_range(world_from_clip, viewer_.metric_depth_plane);
  lighting_ = lighting_of(input.scene, to_viewer_from(middle_at(world_from_clip, 0.5), viewer_.eye));
  for (const Instance& instance : input.scene.instances()) {
    clip_from_object_.push_back(input.viewing.clip_from_object(instance.world_from_object));
  }
}

void ShadeStage::shade_first_layer(const VisibilityBuffer& buffer, Counters& counters) {
  translucent_box_ = {};
  layers_.clear(0, 0);  // what an earlier frame of this Renderer gathered
  for (int y = 0; y < buffer.height(); ++y) {
    const std::uint32_t* const ids = buffer.primitive.row(y);
    const float* const depths = buffer.reversed_depth.row(y);
    for (int x = 0; x < buffer.width(); ++x) {
      if (ids[x] == no_primitive) {
        write_background(x, y);
      } else {
        shade_first(x, y, ids[x], depths[x]);
        ++counters.pixels_shaded;
      }
    }
  }
  counters.layers = 1;
}

// Layer after layer, not pixel after pixel: neighbours show the same triangle, which is then set up once.
void ShadeStage::shade_behind(const FragmentLists& lists, const Rect& part, Counters& counters) {
  open_part(part);
  std::uint64_t layers = 1;
  const std::uint64_t limit = input_.settings.layers;
  for (; !layers_.open.empty() && (limit == 0 || layers < limit); ++layers) {
    std::erase_if(layers_.open, [&](const LayerBuffers::OpenPixel& pixel) {
      const auto list = lists.at(pixel.column + input_.rect.left, pixel.row + input_.rect.top);
      const std::uint64_t fragment = layers <= list.size() ? list[layers - 1] : 0;
      if (fragment == 0) return true;
      ++counters.pixels_shaded;
      return !shade_further(pixel.column, pixel.row, fragment);
    });
  }
  counters.layers = std::max(counters.layers, layers);
}

void ShadeStage::finish() {
  if (layers_.colour.is_empty()) return;
  const glm::vec4 background = linear_from_srgb(input_.settings.background);
  for (int y = 0; y < layers_.colour.height(); ++y) {
    for (int x = 0; x < layers_.colour.width(); ++x) {
      if (!layers_.is_translucent.at(x, y)) continue;
      const glm::vec4 front = layers_.colour.at(x, y);
      const float behind = (1.0f - front.w) * background.w;
      const float alpha = front.w + behind;
      const glm::vec3 premultiplied = glm::vec3(front) + glm::vec3(background) * behind;
      const glm::vec3 straight = alpha > 0.0f ? premultiplied / alpha : glm::vec3(0.0f);
      target_.colour.at(x, y) = srgb_from_linear(glm::vec4(straight, alpha));
    }
  }
}

SurfacePoint ShadeStage::surface(int x, int y, float reversed_depth) const {
  const int column = x + input_.rect.left;
  const int row = y + input_.rect.top;
  if (visible_.kind != PrimitiveKind::triangle)
    return surface_point(visible_.line, column, row, reversed_depth);
  return surface_point(visible_.triangle, column, row, reversed_depth);
}

void ShadeStage::shade_first(int x, int y, std::uint32_t primitive, float reversed_depth) {
  set_primitive(primitive);
  const SurfacePoint point = surface(x, y, reversed_depth);
  if (target_.depth.data) target_.depth.at(x, y) = point.depth;
  if (target_.metric_depth.data) target_.metric_depth.at(x, y) = static_cast<float>(point.metric_depth);
  if (target_.normal.data) target_.normal.at(x, y) = point.shading_normal;
  if (target_.object_id.data) target_.object_id.at(x, y) = point.object;
  if (target_.triangle_id.data) target_.triangle_id.at(x, y) = primitive;
  if (!target_.colour.data) return;
  glm::vec4 colour = colour_of(point);
  if (is_wire(x, y, reversed_depth)) colour = wireframe_ink(colour);
  if (colour.w >= 1.0f) {
    target_.colour.at(x, y) = srgb_from_linear(colour);
  } else {
    open(x, y);
    add_behind(x, y, colour);
  }
}

void ShadeStage::write_background(int x, int y) {
  const bool is_wire = input_.wireframe && input_.wireframe->primitive.at(x, y) != no_primitive;
  const Rgba8 background = input_.settings.background;
  if (target_.colour.data) {
    target_.colour.at(x, y) =
        is_wire ? srgb_from_linear(wireframe_ink(linear_from_srgb(background))) : background;
  }
  if (target_.depth.data) target_.depth.at(x, y) = 1.0f;
  if (target_.metric_depth.data) target_.metric_depth.at(x, y) = std::numeric_limits<float>::infinity();
  if (target_.normal.data) target_.normal.at(x, y) = glm::vec3(0.0f);
  if (target_.object_id.data) target_.object_id.at(x, y) = no_primitive;
  if (target_.triangle_id.data) target_.triangle_id.at(x, y) = no_primitive;
}

void ShadeStage::open(int x, int y) {
  if (translucent_box_.is_empty()) layers_.clear(input_.rect.width, input_.rect.height);
  layers_.is_translucent.at(x, y) = 1;
  const Rect pixel{x + input_.rect.left, y + input_.rect.top, 1, 1};
  translucent_box_ = translucent_box_.is_empty() ? pixel : united(translucent_box_, pixel);
}

void ShadeStage::open_part(const Rect& part) {
  layers_.open.clear();
  for (int y = part.top - input_.rect.top; y < part.bottom() - input_.rect.top; ++y) {
    for (int x = part.left - input_.rect.left; x < part.right() - input_.rect.left; ++x) {
      if (!layers_.is_translucent.at(x, y)) continue;
      layers_.open.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
    }
  }
}

/// @return whether a further layer may still show
bool ShadeStage::add_behind(int x, int y, const glm::vec4& colour) {
  const float alpha = colour.w > 0.0f ? (colour.w < 1.0f ? colour.w : 1.0f) : 0.0f;
  glm::vec4& front = layers_.colour.at(x, y);
  const float share = (1.0f - front.w) * alpha;
  front = glm::vec4(glm::vec3(front) + glm::vec3(colour) * share, front.w + share);
  return alpha < 1.0f;
}

/// @return whether a further layer may still show
bool ShadeStage::shade_further(int x, int y, std::uint64_t fragment) {
  set_primitive(primitive_of(fragment));
  return add_behind(x, y, colour_of(surface(x, y, reversed_depth_of(fragment))));
}

void ShadeStage::set_primitive(std::uint32_t primitive) {
  if (visible_.primitive == primitive) return;
  const PrimitivePlace place = input_.scene.place(primitive);
  visible_.primitive = primitive;
  visible_.kind = place.kind;
  if (place.kind == PrimitiveKind::triangle)
    set_triangle(place);
  else
    set_line(place);
}

void ShadeStage::set_triangle(const PrimitivePlace& place) {
  TriangleView& view = visible_.triangle;
  view = view_triangle(input_.scene, place, clip_from_object_[place.instance], viewer_);
  visible_.lit = light_triangle(input_.settings.shading, lighting_, view);
  if (input_.wireframe) visible_.depth = depth_plane(view.clip, view.determinant, viewer_.viewport);
}

void ShadeStage::set_line(const PrimitivePlace& place) {
  const glm::dmat4& clip_from_object = clip_from_object_[place.instance];
  const bool x_major = is_x_major(input_.scene, place, clip_from_object, viewer_.viewport);
  visible_.line = view_line(input_.scene, place, clip_from_object, viewer_, x_major);
}

glm::vec4 ShadeStage::colour_of(const SurfacePoint& point) const {
  const RenderSettings& settings = input_.settings;
  if (settings.shader) return settings.shader(point);
  if (point.kind != PrimitiveKind::triangle) return shade_line(settings.shading, lighting_, point, range_);
  return shade(settings.shading, lighting_, visible_.lit, point, range_);
}

bool ShadeStage::is_wire(int x, int y, float reversed_depth) const {
  if (!input_.wireframe || input_.wireframe->primitive.at(x, y) == no_primitive) return false;
  const float edge_r = input_.wireframe->reversed_depth.at(x, y);
  if (visible_.kind != PrimitiveKind::triangle) return edge_r >= reversed_depth;
  return is_edge_seen(visible_.depth, edge_r, x + input_.rect.left, y + input_.rect.top,
                      input_.settings.line_width);
}

}  // namespace velum
