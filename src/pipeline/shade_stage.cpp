#include "shade_stage.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "../shading/wireframe.hpp"
#include "../visibility/tile_grid.hpp"
#include "memory_need.hpp"

namespace velum {

namespace {

/// Rows that a worker takes at a time where nothing but the ids matters: memory is then read in order.
constexpr int band_height = 16;
/// Pixels from which on a picture's outputs are larger than a core's own caches.
constexpr int large_picture = 1 << 19;

template <typename T>
void fill(const ImageView<T>& view, const ShadeRun& run, const T& value) {
  if (view.data != nullptr) std::fill(view.row(run.row) + run.begin, view.row(run.row) + run.end, value);
}

/// Whether depths and ids are not all that the wanted outputs take.
bool needs_surfaces(const ShadeContext& context, const PictureTarget& target) {
  const bool has_id_colours =
      context.has_plain_triangles() && context.input.settings.shading == Shading::triangle_id;
  return (target.colour.data != nullptr && !has_id_colours) || target.metric_depth.data != nullptr ||
         target.normal.data != nullptr || target.object_id.data != nullptr;
}

}  // namespace

ShadeStage::ShadeStage(const ShadeInput& input, const PictureTarget& target, LayerBuffers& layers,
                       std::vector<PixelShader>& shaders)
    : context_(input),
      target_(target),
      needs_surfaces_(needs_surfaces(context_, target)),
      layers_(layers),
      shaders_(shaders) {
  shaders_.resize(static_cast<std::size_t>(input.executor.threads()));
  for (PixelShader& shader : shaders_) shader.begin(context_);
  const bool needs_layers = target.colour.data != nullptr && may_be_translucent(input.scene, input.settings);
  layers_.clear(needs_layers ? input.rect.width : 0, needs_layers ? input.rect.height : 0);
}

void ShadeStage::shade_first_layer(const VisibilityBuffer& buffer, Counters& counters) {
  std::vector<Found> found(shaders_.size());
  if (needs_surfaces_) {
    const TileGrid grid({0, 0, buffer.width(), buffer.height()});
    for_each(static_cast<std::size_t>(grid.count()), [&](std::size_t i, std::size_t worker) {
      const Rect tile{grid.left(static_cast<int>(i)), grid.top(static_cast<int>(i)), tile_size, tile_size};
      shade_tile(buffer, intersect(tile, grid.target), shaders_[worker], found[worker]);
    });
  } else {
    const int bands = (buffer.height() + band_height - 1) / band_height;
    for_each(static_cast<std::size_t>(bands), [&](std::size_t i, std::size_t worker) {
      const int top = static_cast<int>(i) * band_height;
      const Rect band{0, top, buffer.width(), std::min(band_height, buffer.height() - top)};
      found[worker].shaded += shade_stored(buffer, band);
    });
  }
  translucent_box_ = {};
  for (const Found& part : found) {
    counters.pixels_shaded += part.shaded;
    translucent_box_ = united(translucent_box_, part.translucent_box);
  }
  counters.layers = 1;
}

template <typename Function>
void ShadeStage::for_each(std::size_t count, const Function& function) {
  if (input_.settings.shader) {
    for (std::size_t i = 0; i < count; ++i) function(i, 0);
  } else {
    input_.executor.for_each(
        count, [&](std::size_t i, int worker) { function(i, static_cast<std::size_t>(worker)); });
  }
}

/// Writes what follows from the stored depths and ids alone. @return the number of visible pixels
std::uint64_t ShadeStage::shade_stored(const VisibilityBuffer& buffer, const Rect& part) const {
  PlainRows rows{};
  rows.width = part.width;
  rows.height = part.height;
  rows.ids = buffer.primitive.row(part.top) + part.left;
  rows.ids_stride = buffer.primitive.stride();
  rows.reversed_depth = buffer.reversed_depth.row(part.top) + part.left;
  rows.reversed_depth_stride = buffer.reversed_depth.stride();
  if (target_.depth.data != nullptr) {
    rows.depth = target_.depth.row(part.top) + part.left;
    rows.depth_stride = target_.depth.stride;
  }
  if (target_.colour.data != nullptr && !needs_surfaces_) {
    rows.colour = reinterpret_cast<std::uint8_t*>(target_.colour.row(part.top) + part.left);
    rows.colour_stride = target_.colour.stride;
    std::memcpy(rows.background, &input_.settings.background, sizeof rows.background);
  }
  if (target_.triangle_id.data != nullptr) {
    for (int y = part.top; y < part.bottom(); ++y)
      std::copy_n(buffer.primitive.row(y) + part.left, part.width, target_.triangle_id.row(y) + part.left);
  }
  rows.is_large = buffer.width() * buffer.height() >= large_picture;
  return shade_plain_(rows);
}

void ShadeStage::shade_tile(const VisibilityBuffer& buffer, const Rect& tile, PixelShader& shader,
                            Found& found) {
  found.shaded += shade_stored(buffer, tile);
  for (int y = tile.top; y < tile.bottom(); ++y) {
    const std::uint32_t* const ids = buffer.primitive.row(y);
    const float* const depths = buffer.reversed_depth.row(y);
    for (int begin = tile.left, end = begin; begin < tile.right(); begin = end) {
      while (end < tile.right() && ids[end] == ids[begin]) ++end;
      const ShadeRun run{y, begin, end, ids[begin]};
      if (run.primitive == no_primitive) {
        write_background(run);
      } else {
        shade_run(run, depths, shader, found);
      }
    }
  }
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
  if (translucent_box_.is_empty()) return;
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

void ShadeStage::shade_run(const ShadeRun& run, const float* reversed_depths, PixelShader& shader,
                           Found& found) {
  shader.select(run.primitive);
  fill(target_.object_id, run, shader.selected().object);
  if (shader.selected().plain_colour) {
    fill(target_.colour, run, *shader.selected().plain_colour);
    return;
  }
  for (int x = run.begin; x < run.end; ++x) shade_point(x, run.row, reversed_depths[x], shader, found);
}

void ShadeStage::shade_point(int x, int y, float reversed_depth, PixelShader& shader, Found& found) {
  const SurfacePoint point = shader.surface(x, y, reversed_depth);
  if (target_.metric_depth.data) target_.metric_depth.at(x, y) = static_cast<float>(point.metric_depth);
  if (target_.normal.data) target_.normal.at(x, y) = point.shading_normal;
  if (!target_.colour.data) return;
  glm::vec4 colour = shader.colour_of(point);
  if (shader.is_wire(x, y, reversed_depth)) colour = wireframe_ink(colour);
  // Where nothing is translucent, less than 1 is the rounding of an interpolation.
  if (colour.w >= 1.0f || layers_.colour.is_empty()) {
    target_.colour.at(x, y) = srgb_from_linear(colour);
  } else {
    open(x, y, found);
    add_behind(x, y, colour);
  }
}

void ShadeStage::write_background(const ShadeRun& run) {
  fill(target_.colour, run, input_.settings.background);
  fill(target_.metric_depth, run, std::numeric_limits<float>::infinity());
  fill(target_.normal, run, glm::vec3(0.0f));
  fill(target_.object_id, run, no_primitive);
  if (input_.wireframe == nullptr || target_.colour.data == nullptr) return;
  const Rgba8 ink = srgb_from_linear(wireframe_ink(linear_from_srgb(input_.settings.background)));
  for (int x = run.begin; x < run.end; ++x) {
    if (input_.wireframe->primitive.at(x, run.row) != no_primitive) target_.colour.at(x, run.row) = ink;
  }
}

void ShadeStage::open(int x, int y, Found& found) {
  layers_.is_translucent.at(x, y) = 1;
  found.translucent_box = united(found.translucent_box, {x + input_.rect.left, y + input_.rect.top, 1, 1});
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
  PixelShader& shader = shaders_.front();
  shader.select(primitive_of(fragment));
  return add_behind(x, y, shader.colour_of(shader.surface(x, y, reversed_depth_of(fragment))));
}

}  // namespace velum
