#include "row_shader.hpp"

#include "../shading/debug_colours.hpp"

namespace velum {
namespace {

bool is_lit(Shading shading) {
  return shading == Shading::flat || shading == Shading::gouraud || shading == Shading::phong;
}

void copy(const glm::vec3& from, float (&to)[3]) {
  to[0] = from.x, to[1] = from.y, to[2] = from.z;
}

}  // namespace

RowContext::RowContext(const ShadeContext& shade_context, const PictureTarget& target)
    : context(shade_context) {
  const RenderSettings& settings = context.input.settings;
  const Shading shading = settings.shading;
  const bool wants_colour = target.colour.data != nullptr;
  is_used =
      settings.isa != Isa::reference && !settings.has_custom_shader() && context.input.wireframe == nullptr;
  has_colour = wants_colour && shading != Shading::object_id && shading != Shading::triangle_id;
  has_linear = has_colour && is_lit(shading);
  needs.viewer = wants_colour && shading == Shading::phong;
  needs.metric_depth = target.metric_depth.data != nullptr || (wants_colour && shading == Shading::depth);
  needs.normal =
      target.normal.data != nullptr || needs.viewer || (wants_colour && shading == Shading::normal);
  needs.colour = has_linear;
  if (!is_used) return;
  interpolate = interpolate_surface_kernel(settings.isa);
  lay_texture = texture_row_kernel(settings.isa);
  light = light_row_kernel(settings.isa);
}

bool RowShader::can_shade(const VisiblePrimitive& primitive) const {
  if (!context_->is_used || primitive.kind != PrimitiveKind::triangle) return false;
  return primitive.triangle.determinant != 0.0;
}

void RowShader::start(int x, int y) {
  x_ = x;
  y_ = y;
  stretch_count_ = 0;
}

void RowShader::add(PixelShader& shader, std::size_t begin, std::size_t end) {
  const Material& shown = *shader.selected().triangle.material;
  SurfaceNeeds needs = context_->needs;
  needs.texture = context_->has_linear && shown.texture != nullptr;
  context_->interpolate({&shader.planes(), x_, y_, begin, end, needs, &row_});
  if (needs.texture) lay_texture(shown, shader.planes(), begin, end);
  const Material* const material = context_->needs.viewer ? &shown : nullptr;
  if (stretch_count_ > 0) {
    Stretch& last = stretches_[stretch_count_ - 1];
    if (last.material == material && last.end == begin) {
      last.end = end;
      return;
    }
  }
  stretches_[stretch_count_++] = {material, begin, end};
}

void RowShader::lay_texture(const Material& material, const TrianglePlanes& planes, std::size_t begin,
                            std::size_t end) {
  if (texture_of_ != &material) {
    texture_of_ = &material;
    texture_ = row_texture_of(material, context_->context.input.settings.texture_filter);
  }
  context_->lay_texture({&planes, &texture_, begin, end, &row_});
}

void RowShader::finish() {
  if (!context_->needs.viewer) return;
  for (const Stretch& stretch : stretches()) light(stretch);
}

void RowShader::light(const Stretch& stretch) {
  const Material& material = *stretch.material;
  LightingWork work{};
  const std::vector<RowLight>& lights = context_->context.own.row_lights;
  work.lights = lights.data();
  work.light_count = lights.size();
  copy(context_->context.lighting.ambient * material.ambient, work.ambient);
  copy(material.diffuse, work.diffuse);
  copy(material.specular, work.specular);
  work.shininess = static_cast<double>(material.shininess);
  work.begin = stretch.begin;
  work.end = stretch.end;
  work.row = &row_;
  context_->light(work);
}

Rgba8 RowShader::codes_at(std::size_t i) const {
  switch (context_->context.input.settings.shading) {
    case Shading::normal:
      return codes_of(normal_values({row_.normal[0][i], row_.normal[1][i], row_.normal[2][i]}));
    case Shading::depth:
      return codes_of(depth_values(row_.metric_depth[i], context_->context.range));
    default:
      return codes_of({row_.barycentric[0][i], row_.barycentric[1][i], row_.barycentric[2][i]});
  }
}

}  // namespace velum
