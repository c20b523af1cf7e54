#include "sample_stage.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "memory_need.hpp"

namespace velum {
namespace {

constexpr std::uint32_t near_wire = 1u << 31;

/// With the samples' own wireframe. Points are always wanted, so that the set of outputs changes no colour.
ShadeInput with_samples(ShadeInput input, const SampleBuffers& buffers) {
  input.needs_points = true;
  input.wireframe = input.settings.wireframe ? &buffers.wireframe.nearest : nullptr;
  return input;
}

template <typename T>
void write(const ImageView<T>& view, const MixedPixel& pixel, const T& value) {
  if (view.data != nullptr) view.at(pixel.column, pixel.row) = value;
}

}  // namespace

void MixedRows::clear() {
  pixels.clear();
  open.clear();
  groups.clear();
  shaded = 0;
  layers = 1;
}

SampleStage::SampleStage(const ShadeInput& input, const PictureTarget& target, SampleBuffers& buffers,
                         DrawSample draw)
    : centre_wires_(input.wireframe),
      context_(with_samples(input, buffers)),
      target_(target),
      buffers_(buffers),
      draw_(std::move(draw)),
      may_be_open_(may_be_translucent(input.scene, input.settings)) {
  buffers.seen.resize(static_cast<std::size_t>(count_));
  buffers.shaders.resize(static_cast<std::size_t>(input.executor.threads()));
  buffers.rows.resize(static_cast<std::size_t>((input.rect.height + run_height - 1) / run_height));
  for (PixelShader& shader : buffers.shaders) shader.begin(context_);
}

void SampleStage::find_mixed_pixels(VisibilityBuffer& centres) {
  const bool has_wires = input_.settings.wireframe;
  buffers_.wires.resize(has_wires ? input_.rect.width : 0, has_wires ? input_.rect.height : 0);
  for (int k = 0; k < count_; ++k) {
    draw_(k, input_.rect, buffers_.seen[static_cast<std::size_t>(k)], nullptr);
    if (!has_wires) continue;
    draw_wireframe({input_.scene, input_.viewing, input_.settings, input_.rect, input_.executor,
                    sample_positions(count_)[static_cast<std::size_t>(k)]},
                   buffers_.wireframe);
    for_each_run(false, [&](const Rect& run, MixedRows&, PixelShader& shader) {
      for (int y = run.top; y < run.bottom(); ++y) mark_wires(k, y, shader);
    });
  }
  for_each_run(false, [&](const Rect& run, MixedRows& found, PixelShader&) {
    found.clear();
    for (int y = run.top; y < run.bottom(); ++y) find_in_row(y, centres, found);
  });
}

/// Notes where an edge is seen at a sample: in front of the surface there, or over the background.
void SampleStage::mark_wires(int sample, int row, PixelShader& shader) const {
  const VisibilityBuffer& edges = buffers_.wireframe.nearest;
  const VisibilityBuffer& seen = buffers_.seen[static_cast<std::size_t>(sample)];
  for (int x = 0; x < input_.rect.width; ++x) {
    if (edges.primitive.at(x, row) == no_primitive) continue;
    std::uint32_t& wires = buffers_.wires.at(x, row);
    wires |= near_wire;
    bool is_seen = true;
    if (const std::uint32_t primitive = seen.primitive.at(x, row); primitive != no_primitive) {
      shader.select(primitive);
      is_seen = shader.is_wire(x, row, sample_positions(count_)[static_cast<std::size_t>(sample)],
                               seen.reversed_depth.at(x, row));
    }
    if (is_seen) wires |= 1u << sample;
  }
}

void SampleStage::find_in_row(int row, VisibilityBuffer& centres, MixedRows& found) const {
  std::uint32_t* const ids = centres.primitive.row(row);
  float* const depths = centres.reversed_depth.row(row);
  constexpr int chunk = 64;
  for (int left = 0; left < input_.rect.width; left += chunk) {
    const int n = std::min(chunk, input_.rect.width - left);
    std::uint32_t differs[chunk] = {};
    for (const VisibilityBuffer& seen : buffers_.seen) {
      const std::uint32_t* const sample_ids = seen.primitive.row(row) + left;
      for (int i = 0; i < n; ++i) differs[i] |= sample_ids[i] ^ ids[left + i];
    }
    if (centre_wires_ != nullptr) {
      const std::uint32_t* const edges = centre_wires_->primitive.row(row) + left;
      const std::uint32_t* const wires = buffers_.wires.row(row) + left;
      for (int i = 0; i < n; ++i) differs[i] |= wires[i] | (edges[i] ^ no_primitive);
    }
    for (int i = 0; i < n; ++i) {
      if (differs[i] == 0) continue;
      const int x = left + i;
      found.pixels.push_back(
          {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(row), ids[x], depths[x]});
      ids[x] = no_primitive;
      depths[x] = 0.0f;
    }
  }
}

void SampleStage::shade(const LayerBuffers& layers, std::uint64_t most_fragments, Counters& counters) {
  for_each_run(true, [&](const Rect&, MixedRows& rows, PixelShader& shader) {
    for (const MixedPixel& pixel : rows.pixels) {
      write_centre(pixel, shader);
      shade_first_layer(pixel, rows, shader);
    }
  });
  if (may_be_open_ && input_.settings.layers != 1) shade_open_pixels(layers, most_fragments);
  for (const MixedRows& rows : buffers_.rows) {
    counters.pixels_shaded += rows.shaded;
    counters.layers = std::max(counters.layers, rows.layers);
  }
}

void SampleStage::write_centre(const MixedPixel& pixel, PixelShader& shader) const {
  const bool is_seen = pixel.primitive != no_primitive;
  write(target_.depth, pixel, 1.0f - pixel.reversed_depth);
  write(target_.triangle_id, pixel, pixel.primitive);
  if (is_seen) shader.select(pixel.primitive);
  write(target_.object_id, pixel, is_seen ? shader.selected().object : no_primitive);
  if (target_.metric_depth.data == nullptr && target_.normal.data == nullptr) return;
  SurfacePoint point;
  point.metric_depth = std::numeric_limits<double>::infinity();
  if (is_seen) point = shader.surface(pixel.column, pixel.row, pixel.reversed_depth);
  write(target_.metric_depth, pixel, static_cast<float>(point.metric_depth));
  write(target_.normal, pixel, point.shading_normal);
}

/// Shades what the samples see first; the pixel is then done, unless something shines through.
void SampleStage::shade_first_layer(const MixedPixel& pixel, MixedRows& rows, PixelShader& shader) const {
  const std::size_t first = rows.groups.size();
  add_groups(pixel, rows.groups);
  const std::span<SampleGroup> groups = std::span(rows.groups).subspan(first);
  bool is_any_open = false;
  for (SampleGroup& group : groups) {
    const int sample = std::countr_zero(group.samples);
    const float r =
        buffers_.seen[static_cast<std::size_t>(sample)].reversed_depth.at(pixel.column, pixel.row);
    shade_group(pixel.column, pixel.row, group, r, shader);
    is_any_open = is_any_open || open_samples(pixel.column, pixel.row, group) != 0;
  }
  rows.shaded += groups.size();
  if (is_any_open) {
    rows.open.push_back({pixel.column, pixel.row, static_cast<std::uint32_t>(first),
                         static_cast<std::uint32_t>(groups.size())});
    return;
  }
  glm::vec4 samples[most_samples];
  put_first_layer(pixel.column, pixel.row, groups, samples);
  write_colour(pixel.column, pixel.row, samples);
  rows.groups.resize(first);
}

/// The primitives that the samples see, in the samples' order.
void SampleStage::add_groups(const MixedPixel& pixel, std::vector<SampleGroup>& groups) const {
  const std::size_t first = groups.size();
  for (int k = 0; k < count_; ++k) {
    const std::uint32_t primitive =
        buffers_.seen[static_cast<std::size_t>(k)].primitive.at(pixel.column, pixel.row);
    if (primitive == no_primitive) continue;
    std::size_t i = first;
    while (i < groups.size() && groups[i].primitive != primitive) ++i;
    if (i == groups.size()) groups.push_back({primitive, 0});
    groups[i].samples |= 1u << k;
  }
}

void SampleStage::shade_group(int column, int row, SampleGroup& group, float reversed_depth,
                              PixelShader& shader) const {
  shader.select(group.primitive);
  const glm::dvec2 centroid = centroid_of(group.samples, count_);
  group.colour = shader.colour_of(shader.surface(column, row, centroid, reversed_depth));
  // Where nothing is translucent, less than 1 is the rounding of an interpolation.
  if (!may_be_open_) group.colour.w = 1.0f;
  group.is_shaded = true;
}

std::uint32_t SampleStage::wires_at(int column, int row) const {
  return buffers_.wires.is_empty() ? 0u : buffers_.wires.at(column, row);
}

/// The samples of a group that a further layer may be seen at.
std::uint32_t SampleStage::open_samples(int column, int row, const SampleGroup& group) const {
  if (group.colour.w >= 1.0f || !may_be_open_ || input_.settings.layers == 1) return 0;
  return group.samples & ~wires_at(column, row);
}

/// Every sample's first layer; transparent where it sees the background.
void SampleStage::put_first_layer(int column, int row, std::span<const SampleGroup> groups,
                                  glm::vec4* samples) const {
  glm::vec4 colours[most_samples];
  std::fill(colours, colours + count_, glm::vec4(0.0f));
  for (const SampleGroup& group : groups) {
    for (int k = 0; k < count_; ++k) {
      if ((group.samples >> k) & 1u) colours[k] = group.colour;
    }
  }
  const std::uint32_t wires = wires_at(column, row);
  for (int k = 0; k < count_; ++k) {
    if ((wires >> k) & 1u) colours[k] = ink_;
    samples[k] = with_behind(glm::vec4(0.0f), colours[k]);
  }
}

void SampleStage::write_colour(int column, int row, glm::vec4* samples) const {
  for (int k = 0; k < count_; ++k) samples[k] = with_behind(samples[k], background_);
  target_.colour.at(column, row) = resolved(samples, count_);
}

}  // namespace velum
