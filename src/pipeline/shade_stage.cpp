#include "shade_stage.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "../visibility/tile_grid.hpp"
#include "memory_need.hpp"

namespace velum {

namespace {

static_assert(tile_size <= static_cast<int>(most_row_pixels));

/// Rows that a worker takes at a time where tiles bring nothing: memory is then read in order.
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
  return (target.colour.data != nullptr && !has_id_colours) || context.input.needs_points ||
         target.object_id.data != nullptr;
}

}  // namespace

ShadeStage::ShadeStage(const ShadeInput& input, const PictureTarget& target, LayerBuffers& layers,
                       ShadeBuffers& buffers)
    : context_(input, &buffers.memory),
      target_(target),
      rows_(context_, target),
      needs_surfaces_(needs_surfaces(context_, target)),
      layers_(layers),
      workers_(buffers.workers) {
  workers_.resize(static_cast<std::size_t>(input.executor.threads()));
  for (ShadeWorker& worker : workers_) {
    worker.points.resize(most_row_pixels);
    worker.pixel.begin(context_);
    worker.row.begin(rows_);
    worker.shaded = 0;
    worker.translucent_box = {};
  }
  const bool needs_layers = target.colour.data != nullptr && may_be_translucent(input.scene, input.settings);
  layers_.clear(needs_layers ? input.rect.width : 0, needs_layers ? input.rect.height : 0);
}

bool ShadeStage::takes_tiles() const {
  return !needs_surfaces_ && input_.wireframe == nullptr && !input_.settings.shader;
}

void ShadeStage::take_tile(const TileBuffer* pixels, const Rect& tile, int worker) {
  const PlainOutput out = plain_output(tile.left - input_.rect.left, tile.top - input_.rect.top);
  workers_[static_cast<std::size_t>(worker)].shaded +=
      shade_plain_tile_({pixels, tile.width, tile.height, out});
}

void ShadeStage::shade_first_layer(const VisibilityBuffer& buffer, Counters& counters) {
  if (needs_surfaces_) {
    const TileGrid grid({0, 0, buffer.width(), buffer.height()});
    for_each(static_cast<std::size_t>(grid.count()), [&](std::size_t i, ShadeWorker& worker) {
      const Rect tile{grid.left(static_cast<int>(i)), grid.top(static_cast<int>(i)), tile_size, tile_size};
      shade_tile(buffer, intersect(tile, grid.target), worker);
    });
  } else {
    for_each_band(0, buffer.height(), [&](int top, int bottom, ShadeWorker& worker) {
      worker.shaded += shade_stored(buffer, {0, top, buffer.width(), bottom - top});
    });
  }
  end_first_layer(counters);
}

void ShadeStage::end_first_layer(Counters& counters) {
  translucent_box_ = {};
  for (const ShadeWorker& worker : workers_) {
    counters.pixels_shaded += worker.shaded;
    translucent_box_ = united(translucent_box_, worker.translucent_box);
  }
  counters.layers = 1;
}

template <typename Function>
void ShadeStage::for_each(std::size_t count, const Function& function) {
  if (input_.settings.shader && !input_.settings.inlined_shader) {
    for (std::size_t i = 0; i < count; ++i) function(i, workers_.front());
  } else {
    input_.executor.for_each(
        count, [&](std::size_t i, int worker) { function(i, workers_[static_cast<std::size_t>(worker)]); });
  }
}

template <typename Function>
void ShadeStage::for_each_band(int top, int bottom, const Function& function) {
  const int bands = (bottom - top + band_height - 1) / band_height;
  for_each(static_cast<std::size_t>(bands), [&](std::size_t i, ShadeWorker& worker) {
    const int first = top + static_cast<int>(i) * band_height;
    function(first, std::min(bottom, first + band_height), worker);
  });
}

/// Where what follows from depths and ids alone goes.
/// @param left, top  the first pixel, counted from the part that is rendered
PlainOutput ShadeStage::plain_output(int left, int top) const {
  PlainOutput out{};
  if (target_.depth.data != nullptr) {
    out.depth = target_.depth.row(top) + left;
    out.depth_stride = target_.depth.stride;
  }
  if (target_.triangle_id.data != nullptr) {
    out.ids = target_.triangle_id.row(top) + left;
    out.ids_stride = target_.triangle_id.stride;
  }
  if (target_.colour.data != nullptr && !needs_surfaces_) {
    out.colour = reinterpret_cast<std::uint8_t*>(target_.colour.row(top) + left);
    out.colour_stride = target_.colour.stride;
    std::memcpy(out.background, &input_.settings.background, sizeof out.background);
  }
  out.is_large = input_.rect.width * input_.rect.height >= large_picture;
  return out;
}

/// Writes what follows from the stored depths and ids alone.
/// @return the number of visible pixels
std::uint64_t ShadeStage::shade_stored(const VisibilityBuffer& buffer, const Rect& part) const {
  return shade_plain_rows_({part.width, part.height, buffer.primitive.row(part.top) + part.left,
                            buffer.primitive.stride(), buffer.reversed_depth.row(part.top) + part.left,
                            buffer.reversed_depth.stride(), plain_output(part.left, part.top)});
}

void ShadeStage::shade_tile(const VisibilityBuffer& buffer, const Rect& tile, ShadeWorker& worker) {
  worker.shaded += shade_stored(buffer, tile);
  for (int y = tile.top; y < tile.bottom(); ++y) {
    const std::uint32_t* const ids = buffer.primitive.row(y);
    const float* const depths = buffer.reversed_depth.row(y);
    worker.row.start(tile.left + input_.rect.left, y + input_.rect.top);
    for (int begin = tile.left, end = begin; begin < tile.right(); begin = end) {
      while (end < tile.right() && ids[end] == ids[begin]) ++end;
      const ShadeRun run{y, begin, end, ids[begin]};
      if (run.primitive == no_primitive) {
        write_background(run);
      } else {
        shade_run(run, tile.left, depths, worker);
      }
    }
    worker.row.finish();
    for (const RowShader::Stretch& stretch : worker.row.stretches())
      write_stretch(y, tile.left, stretch, worker);
  }
}

void ShadeStage::shade_run(const ShadeRun& run, int left, const float* reversed_depths, ShadeWorker& worker) {
  PixelShader& shader = worker.pixel;
  shader.select(run.primitive);
  const VisiblePrimitive& visible = shader.selected();
  fill(target_.object_id, run, visible.object);
  if (visible.plain_colour) fill(target_.colour, run, *visible.plain_colour);
  if (!input_.needs_points && (visible.plain_colour || target_.colour.data == nullptr)) return;
  if (worker.row.can_shade(visible)) {
    worker.row.add(shader, static_cast<std::size_t>(run.begin - left),
                   static_cast<std::size_t>(run.end - left));
    return;
  }
  shade_points(run, reversed_depths, worker);
}

/// Writes pixels that the RowShader has done. @param left  its first pixel
void ShadeStage::write_stretch(int y, int left, const RowShader::Stretch& stretch, ShadeWorker& worker) {
  const SurfaceRow& row = worker.row.row();
  const auto [unused, begin, end] = stretch;
  const std::ptrdiff_t x = left + static_cast<std::ptrdiff_t>(begin);
  if (target_.metric_depth.data != nullptr) {
    std::transform(row.metric_depth + begin, row.metric_depth + end, target_.metric_depth.row(y) + x,
                   [](double depth) { return static_cast<float>(depth); });
  }
  if (target_.normal.data != nullptr) {
    glm::vec3* const normals = target_.normal.row(y) + left;
    for (std::size_t i = begin; i < end; ++i)
      normals[i] = {row.normal[0][i], row.normal[1][i], row.normal[2][i]};
  }
  if (!rows_.has_colour) return;
  if (!rows_.has_linear) {
    Rgba8* const colours = target_.colour.row(y) + left;
    for (std::size_t i = begin; i < end; ++i) colours[i] = worker.row.codes_at(i);
  } else if (layers_.colour.is_empty()) {
    const float* const channels[4] = {row.colour[0] + begin, row.colour[1] + begin, row.colour[2] + begin,
                                      row.colour[3] + begin};
    srgb_from_linear(channels, end - begin, target_.colour.row(y) + x);
  } else {
    for (std::size_t i = begin; i < end; ++i) {
      const glm::vec4 colour(row.colour[0][i], row.colour[1][i], row.colour[2][i], row.colour[3][i]);
      write_colour(left + static_cast<int>(i), y, colour, worker);
    }
  }
}

/// Pixels that the vector kernels leave out, or a custom shader takes.
void ShadeStage::shade_points(const ShadeRun& run, const float* reversed_depths, ShadeWorker& worker) {
  PixelShader& shader = worker.pixel;
  for (int x = run.begin; x < run.end; ++x) {
    SurfacePoint& point = worker.points[static_cast<std::size_t>(x - run.begin)];
    point = shader.surface(x, run.row, reversed_depths[x]);
    if (target_.metric_depth.data)
      target_.metric_depth.at(x, run.row) = static_cast<float>(point.metric_depth);
    if (target_.normal.data) target_.normal.at(x, run.row) = point.shading_normal;
  }
  if (!target_.colour.data) return;
  shader.colours_of(worker.points.data(), static_cast<std::size_t>(run.end - run.begin),
                    worker.colours.data());
  for (int x = run.begin; x < run.end; ++x) {
    const glm::vec4& colour = worker.colours[static_cast<std::size_t>(x - run.begin)];
    const bool is_wire = shader.is_wire(x, run.row, reversed_depths[x]);
    write_colour(x, run.row, is_wire ? ink_ : colour, worker);
  }
}

void ShadeStage::write_colour(int x, int y, const glm::vec4& colour, ShadeWorker& worker) {
  // Where nothing is translucent, less than 1 is the rounding of an interpolation.
  if (colour.w >= 1.0f || layers_.colour.is_empty()) {
    target_.colour.at(x, y) = srgb_from_linear(colour);
    return;
  }
  layers_.is_translucent.at(x, y) = 1;
  worker.translucent_box = united(worker.translucent_box, {x + input_.rect.left, y + input_.rect.top, 1, 1});
  add_behind(colour, layers_.colour.at(x, y));
}

void ShadeStage::write_background(const ShadeRun& run) {
  fill(target_.colour, run, input_.settings.background);
  fill(target_.metric_depth, run, std::numeric_limits<float>::infinity());
  fill(target_.normal, run, glm::vec3(0.0f));
  fill(target_.object_id, run, no_primitive);
  if (input_.wireframe == nullptr || target_.colour.data == nullptr) return;
  const Rgba8 ink = srgb_from_linear(ink_);
  for (int x = run.begin; x < run.end; ++x) {
    if (input_.wireframe->primitive.at(x, run.row) != no_primitive) target_.colour.at(x, run.row) = ink;
  }
}

// Layer after layer, not pixel after pixel: neighbours show the same triangle, which is then set up once.
void ShadeStage::shade_behind(const FragmentLists& lists, const Rect& part, Counters& counters) {
  for (ShadeWorker& worker : workers_) worker.shaded = worker.layers = 0;
  const std::uint64_t limit = input_.settings.layers;
  for_each_band(part.top, part.bottom(), [&](int top, int bottom, ShadeWorker& worker) {
    open_band({part.left, top, part.width, bottom - top}, worker);
    std::uint64_t layers = 1;
    for (; !worker.open.empty() && (limit == 0 || layers < limit); ++layers) {
      std::erase_if(worker.open, [&](const LayerBuffers::OpenPixel& pixel) {
        const auto list = lists.at(pixel.column + input_.rect.left, pixel.row + input_.rect.top);
        const std::uint64_t fragment = layers <= list.size() ? list[layers - 1] : 0;
        if (fragment == 0) return true;
        ++worker.shaded;
        return !shade_further(pixel.column, pixel.row, fragment, worker.pixel);
      });
    }
    worker.layers = std::max(worker.layers, layers);
  });
  // Which worker takes which band is left to chance: all get the room that one needed, for the next frame.
  std::size_t room = 0;
  for (const ShadeWorker& worker : workers_) {
    counters.pixels_shaded += worker.shaded;
    counters.layers = std::max(counters.layers, worker.layers);
    room = std::max(room, worker.open.capacity());
  }
  for (ShadeWorker& worker : workers_) worker.open.reserve(room);
}

/// @param band  picture pixels
void ShadeStage::open_band(const Rect& band, ShadeWorker& worker) const {
  worker.open.clear();
  for (int y = band.top - input_.rect.top; y < band.bottom() - input_.rect.top; ++y) {
    for (int x = band.left - input_.rect.left; x < band.right() - input_.rect.left; ++x) {
      if (!layers_.is_translucent.at(x, y)) continue;
      worker.open.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
    }
  }
}

/// @return whether a further layer may still show
bool ShadeStage::shade_further(int x, int y, std::uint64_t fragment, PixelShader& shader) {
  shader.select(primitive_of(fragment));
  const glm::vec4 colour = shader.colour_of(shader.surface(x, y, reversed_depth_of(fragment)));
  return add_behind(colour, layers_.colour.at(x, y));
}

void ShadeStage::finish() {
  if (translucent_box_.is_empty()) return;
  const glm::vec4 background = linear_from_srgb(input_.settings.background);
  for_each_band(0, layers_.colour.height(), [&](int top, int bottom, ShadeWorker&) {
    for (int y = top; y < bottom; ++y) {
      for (int x = 0; x < layers_.colour.width(); ++x) {
        if (!layers_.is_translucent.at(x, y)) continue;
        target_.colour.at(x, y) = over_background(layers_.colour.at(x, y), background);
      }
    }
  });
}

}  // namespace velum
