#include "pixel_shader.hpp"

#include <utility>

#include "../shading/light_scene.hpp"
#include "line_stages.hpp"
#include "wireframe_stage.hpp"

namespace velum {
namespace {

/// Primitives kept set up per worker: those of a tile, most often; about 250 kB.
constexpr int place_bits = 8;

/// Spreads ids over the places (Knuth 1973, multiplicative hashing).
std::size_t place_of(std::uint32_t primitive) {
  return (primitive * 0x9E3779B1u) >> (32 - place_bits);
}

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

void set_row_lights(const Lighting& lighting, std::vector<RowLight>& lights) {
  const auto add = [&](const glm::dvec3& towards, const glm::vec3& radiance, bool is_place) {
    lights.push_back({{towards.x, towards.y, towards.z}, {radiance.x, radiance.y, radiance.z}, is_place});
  };
  lights.clear();
  for (const DirectionalLight& light : lighting.directional) add(-light.direction, light.radiance, false);
  for (const PointLight& light : lighting.points) add(light.position, light.radiance, true);
}

}  // namespace

ShadeContext::ShadeContext(const ShadeInput& shade_input, ShadeMemory* kept)
    : input(shade_input), kept_(kept) {
  if (kept_ != nullptr) std::swap(own, *kept_);
  const glm::dmat4 world_from_clip = input.viewing.world_from_clip();
  viewer.viewport = {input.settings.width, input.settings.height};
  viewer.eye = eye_of(input.viewing.clip_from_world());
  viewer.metric_depth_plane = metric_depth_plane(input.camera);
  viewer.texture_filter = input.settings.texture_filter;
  range = depth_view_range(world_from_clip, viewer.metric_depth_plane);
  light_scene(input.scene, to_viewer_from(middle_at(world_from_clip, 0.5), viewer.eye), own.lighting);
  set_row_lights(own.lighting, own.row_lights);
  own.clip_from_object.clear();
  for (const Instance& instance : input.scene.instances()) {
    own.clip_from_object.push_back(input.viewing.clip_from_object(instance.world_from_object));
  }
}

ShadeContext::~ShadeContext() {
  if (kept_ != nullptr) std::swap(own, *kept_);
}

bool ShadeContext::has_plain_triangles() const {
  const Shading shading = input.settings.shading;
  const bool is_plain =
      shading == Shading::flat || shading == Shading::object_id || shading == Shading::triangle_id;
  return is_plain && !input.settings.has_custom_shader() && input.wireframe == nullptr;
}

void PixelShader::begin(const ShadeContext& context) {
  context_ = &context;
  selected_ = nullptr;
  lately_.resize(std::size_t{1} << place_bits);
  for (VisiblePrimitive& visible : lately_) visible.primitive = no_primitive;
}

void PixelShader::select(std::uint32_t primitive) {
  if (selected_ != nullptr && selected_->primitive == primitive) return;
  selected_ = &lately_[place_of(primitive)];
  if (selected_->primitive != primitive) set_up(primitive, *selected_);
}

void PixelShader::set_up(std::uint32_t primitive, VisiblePrimitive& visible) const {
  const PrimitivePlace place = context_->input.scene.place(primitive);
  visible.primitive = primitive;
  visible.kind = place.kind;
  visible.object = place.instance;
  visible.plain_colour.reset();
  visible.has_planes = false;
  if (place.kind == PrimitiveKind::triangle)
    set_up_triangle(place, visible);
  else
    set_up_line(place, visible);
}

void PixelShader::set_up_triangle(const PrimitivePlace& place, VisiblePrimitive& visible) const {
  const ShadeInput& input = context_->input;
  const Viewer& viewer = context_->viewer;
  const bool is_plain = context_->has_plain_triangles();
  if (is_plain && input.settings.shading != Shading::flat) {
    const bool by_object = input.settings.shading == Shading::object_id;
    visible.plain_colour = srgb_from_linear(id_colour(by_object ? place.instance : visible.primitive));
    if (!input.needs_points) return;
  }
  visible.triangle = view_triangle(input.scene, place, context_->clip_from_object[place.instance], viewer);
  visible.lit = light_triangle(input.settings.shading, context_->lighting, visible.triangle);
  const bool is_textured = visible.triangle.material->texture != nullptr;
  if (is_plain && !visible.plain_colour && !is_textured && visible.lit.face.a >= 1.0f) {
    visible.plain_colour = srgb_from_linear(visible.lit.face);
  }
  if (input.wireframe == nullptr) return;
  visible.depth = depth_plane(visible.triangle.clip, visible.triangle.determinant, viewer.viewport);
}

void PixelShader::set_up_line(const PrimitivePlace& place, VisiblePrimitive& visible) const {
  const ShadeInput& input = context_->input;
  const Viewer& viewer = context_->viewer;
  const glm::dmat4& clip_from_object = context_->clip_from_object[place.instance];
  const bool x_major = is_x_major(input.scene, place, clip_from_object, viewer.viewport);
  visible.line = view_line(input.scene, place, clip_from_object, viewer, x_major);
}

const TrianglePlanes& PixelShader::planes() {
  VisiblePrimitive& visible = *selected_;
  if (visible.has_planes) return visible.planes;
  visible.has_planes = true;
  const Shading shading = context_->input.settings.shading;
  if (shading == Shading::flat) {
    const glm::vec4& face = visible.lit.face;
    const glm::vec3& highlight = visible.lit.face_highlight;
    const std::array<glm::vec3, 3> highlights{highlight, highlight, highlight};
    visible.planes = planes_of(visible.triangle, {face, face, face}, &highlights);
  } else if (shading == Shading::gouraud) {
    visible.planes = planes_of(visible.triangle, visible.lit.corners, &visible.lit.corner_highlights);
  } else {
    visible.planes = planes_of(visible.triangle, visible.triangle.colours);
  }
  return visible.planes;
}

SurfacePoint PixelShader::surface(int x, int y, float reversed_depth) const {
  return surface(x, y, glm::dvec2(0.0), reversed_depth);
}

SurfacePoint PixelShader::surface(int x, int y, const glm::dvec2& from_centre, float reversed_depth) const {
  const int column = x + context_->input.rect.left;
  const int row = y + context_->input.rect.top;
  const glm::dvec2 at(column + (0.5 + from_centre.x), row + (0.5 + from_centre.y));
  if (selected_->kind != PrimitiveKind::triangle)
    return surface_point(selected_->line, at, column, row, reversed_depth);
  return surface_point(selected_->triangle, at, column, row, reversed_depth);
}

glm::vec4 PixelShader::colour_of(const SurfacePoint& point) const {
  const RenderSettings& settings = context_->input.settings;
  if (settings.inlined_shader) {
    glm::vec4 colour;
    settings.inlined_shader(&point, 1, &colour);
    return colour;
  }
  if (settings.shader) return settings.shader(point);
  if (point.kind != PrimitiveKind::triangle)
    return shade_line(settings.shading, context_->lighting, point, context_->range);
  return shade(settings.shading, context_->lighting, selected_->lit, point, context_->range);
}

void PixelShader::colours_of(const SurfacePoint* points, std::size_t count, glm::vec4* colours) const {
  const ShaderRef& shader = context_->input.settings.inlined_shader;
  if (shader) return shader(points, count, colours);
  for (std::size_t i = 0; i < count; ++i) colours[i] = colour_of(points[i]);
}

bool PixelShader::is_wire(int x, int y, float reversed_depth) const {
  return is_wire(x, y, pixel_centre, reversed_depth);
}

bool PixelShader::is_wire(int x, int y, const SamplePosition& sample, float reversed_depth) const {
  const ShadeInput& input = context_->input;
  if (input.wireframe == nullptr || input.wireframe->primitive.at(x, y) == no_primitive) return false;
  const float edge_r = input.wireframe->reversed_depth.at(x, y);
  if (selected_->kind != PrimitiveKind::triangle) return edge_r >= reversed_depth;
  DepthPlane surface = selected_->depth;
  move_depth(surface, sample);
  return is_edge_seen(surface, edge_r, x + input.rect.left, y + input.rect.top, input.settings.line_width);
}

}  // namespace velum
