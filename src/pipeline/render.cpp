#include "render.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "../base/floating_point.hpp"
#include "check_request.hpp"
#include "frame.hpp"
#include "memory_need.hpp"
#include "supersample_stage.hpp"

namespace velum {

namespace {

/// The most fragments that are kept at a time: each part of the picture that they allow costs another pass
/// over the scene, which so is at most an eighth of the work, unless the memory (bytes) forbids it.
std::uint64_t most_fragments(const Scene& scene, std::uint64_t memory) {
  const std::uint64_t wanted = std::clamp<std::uint64_t>(8 * std::uint64_t{scene.primitive_count()},
                                                         std::uint64_t{1} << 20, std::uint64_t{1} << 31);
  return std::min(wanted, memory / sizeof(std::uint64_t));
}

/// Makes what is not translucent the background in the buffer: nothing lies behind that.
void hide_opaque_pixels(VisibilityBuffer& buffer, const Image<std::uint8_t>& is_translucent) {
  for (int y = 0; y < buffer.height(); ++y) {
    for (int x = 0; x < buffer.width(); ++x) {
      if (is_translucent.at(x, y)) continue;
      buffer.reversed_depth.at(x, y) = 0.0f;
      buffer.primitive.at(x, y) = no_primitive;
    }
  }
}

/// Shades what lies behind the first layer of the translucent pixels: their fragments are counted, then
/// gathered and sorted in parts of the picture that the memory (bytes) allows.
void shade_behind(Frame frame, const Rect& wanted, std::uint64_t memory, ShadeStage& stage,
                  Counters& counters) {
  FragmentLists& lists = frame.buffers.layers.behind;
  hide_opaque_pixels(frame.buffers.visibility, frame.buffers.layers.is_translucent);
  lists.begin_counting(frame.buffers.visibility, frame.rect, wanted);
  frame.lists = &lists;
  frame.rect = frame.within = wanted;
  frame.progress_from = frame.progress_to;
  frame.progress_to = 0.82;
  frame.draw_scene();
  const std::vector<Rect>& parts = lists.parts(most_fragments(frame.scene, memory));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    lists.begin_storing(parts[i]);
    frame.rect = frame.within = parts[i];
    frame.progress_from = frame.progress_to;
    frame.progress_to = 0.82 + 0.18 * static_cast<double>(i + 1) / static_cast<double>(parts.size());
    frame.draw_scene();
    lists.sort();
    stage.shade_behind(lists, parts[i], counters);
  }
}

/// Has as many threads at hand as are asked for.
void prepare(Renderer::Buffers& buffers, const RenderSettings& settings) {
  const bool as_before = buffers.threads == settings.threads && buffers.executor_kind == settings.executor;
  if (as_before) return;
  buffers.executor = Executor(settings.threads, settings.executor);
  buffers.threads = settings.threads;
  buffers.executor_kind = settings.executor;
}

/// How a sample is drawn for the SampleStage: as the centres are, at another place in the pixels. Nothing is
/// counted.
DrawSample sample_drawing(const Frame& centres, Counters& uncounted) {
  return [&](int k, const Rect& rect, VisibilityBuffer& buffer, FragmentLists* lists) {
    const int count = centres.settings.samples;
    Frame frame{centres.scene, centres.settings, centres.viewing, rect, centres.buffers, uncounted, lists};
    frame.sample = sample_positions(count)[static_cast<std::size_t>(k)];
    frame.progress_from = lists == nullptr ? 0.8 * (k + 1) / (count + 1) : 0.81;
    frame.progress_to = lists == nullptr ? 0.8 * (k + 2) / (count + 1) : 0.82;
    if (lists == nullptr) std::swap(buffer, frame.buffers.visibility);
    frame.draw_scene();
    if (lists == nullptr) std::swap(buffer, frame.buffers.visibility);
  };
}

/// The picture, whichever part of it is made.
struct PictureWork {
  Renderer::Buffers& buffers;
  const Scene& scene;
  const Camera& camera;
  const ViewingTransform& viewing;
  const RenderSettings& settings;
  std::uint64_t memory;  ///< bytes left for lists of fragments

  PictureWork with(const RenderSettings& other) const {
    return {buffers, scene, camera, viewing, other, memory};
  }
};

/// Draws and shades what is seen first: tile by tile while they are in cache where that will do.
void draw_first_layer(Frame frame, ShadeStage& stage) {
  const TileSink sink = [&stage](const TileBuffer* pixels, const Rect& tile, int worker) {
    stage.take_tile(pixels, tile, worker);
  };
  if (stage.takes_tiles() && frame.is_for_tiles()) frame.sink = &sink;
  frame.draw_scene();
  if (frame.sink != nullptr) {
    stage.end_first_layer(frame.counters);
  } else {
    stage.shade_first_layer(frame.buffers.visibility, frame.counters);
  }
}

/// Everything there is to do for a part of the picture.
/// @param within  the instances that lie beside this are counted as such; holds `rect`
void render_part(const PictureWork& work, const Rect& rect, const Rect& within, const PictureTarget& target,
                 Counters& counters) {
  const auto& [buffers, scene, camera, viewing, settings, memory] = work;
  Frame centres{scene, settings, viewing, rect, buffers, counters};
  centres.within = within;
  const bool has_samples = settings.samples > 1 && target.colour.data != nullptr;
  if (has_samples) centres.progress_to = 0.8 / (settings.samples + 1);
  ShadeInput input{scene, camera, viewing, settings, rect, buffers.executor};
  input.needs_points = target.metric_depth.data != nullptr || target.normal.data != nullptr;
  if (settings.wireframe) {
    draw_wireframe({scene, viewing, settings, rect, buffers.executor}, buffers.wireframe);
    input.wireframe = &buffers.wireframe.nearest;
  }
  Counters raster_again;  // the geometry is counted once
  std::optional<SampleStage> samples;
  ShadeStage stage(input, target, buffers.layers, buffers.shaders);
  if (has_samples) {
    centres.draw_scene();
    samples.emplace(input, target, buffers.samples, sample_drawing(centres, raster_again));
    samples->find_mixed_pixels(buffers.visibility);
    stage.shade_first_layer(buffers.visibility, counters);
  } else {
    draw_first_layer(centres, stage);
  }
  const Rect translucent = stage.translucent_box();
  if (!translucent.is_empty() && settings.layers != 1 && !samples) {
    shade_behind({scene, settings, viewing, rect, buffers, raster_again}, translucent, memory, stage,
                 counters);
  }
  stage.finish();
  if (samples) samples->shade(buffers.layers, most_fragments(scene, memory), counters);
}

/// The picture in bands that bound what the samples take; most often it is one. The geometry is counted in
/// the first.
void render_bands(const PictureWork& work, const Rect& rect, const PictureTarget& target,
                  Counters& counters) {
  const int most = sample_band_height(work.scene, work.settings, rect);
  if (most == rect.height) return render_part(work, rect, rect, target, counters);
  for (int top = 0; top < rect.height; top += most) {
    const int height = std::min(most, rect.height - top);
    RenderSettings settings = work.settings;
    settings.progress = [&](double share) {
      return !work.settings.progress || work.settings.progress((top + share * height) / rect.height);
    };
    Counters of_band;
    const Rect band{rect.left, rect.top + top, rect.width, height};
    render_part(work.with(settings), band, top == 0 ? rect : band, target.rows(top, height), of_band);
    top == 0 ? counters = of_band : counters += of_band.of_pixels();
  }
}

/// Colour from a picture that is larger, everything else from one of the size asked for.
void render_supersampled(const PictureWork& work, const Rect& rect, const PictureTarget& target,
                         Counters& counters) {
  const RenderSettings& settings = work.settings;
  RenderSettings plain = settings;
  plain.samples = plain.supersample = 1;
  plain.progress = [&settings](double share) { return !settings.progress || settings.progress(0.1 * share); };
  PictureTarget without_colour = target;
  without_colour.colour = {};
  render_part(work.with(plain), rect, rect, without_colour, counters);
  if (target.colour.data == nullptr) return;
  RenderSettings larger = enlarged(settings);
  const RenderColour render = [&](const Rect& part, const ImageView<Rgba8>& colour, double from, double to) {
    larger.progress = [&settings, from, to](double share) {
      return !settings.progress || settings.progress(0.1 + 0.9 * (from + (to - from) * share));
    };
    PictureTarget only_colour;
    only_colour.colour = colour;
    Counters of_band;
    render_bands(work.with(larger), part, only_colour, of_band);
    counters += of_band.of_pixels();
  };
  supersample(settings, rect, target.colour, work.buffers.band, render);
}

/// @param memory  bytes left for lists of fragments
Counters render_frame(Renderer::Buffers& buffers, const Scene& scene, const Camera& camera,
                      const RenderSettings& settings, const PictureTarget& target, std::uint64_t memory) {
  const FloatingPointScope floating_point;
  const Rect rect = requested_rect(settings);
  check_method(settings);
  check_widths(settings);
  check_samples(settings);
  check_supersampling(settings);
  check_machine(settings);
  const ViewingTransform viewing = requested_view(camera, settings);
  prepare(buffers, settings);
  check_target(target, rect);
  Counters counters;
  const PictureWork work{buffers, scene, camera, viewing, settings, memory};
  const auto make = settings.supersample > 1 ? render_supersampled : render_bands;
  make(work, rect, target, counters);
  report_progress(settings, 1.0);
  return counters;
}

/// Gives the picture its size and returns views of all its outputs.
PictureTarget target_of(Picture& picture, const Rect& rect) {
  picture.resize(rect.width, rect.height);
  return {picture.colour.view(), picture.depth.view(),     picture.metric_depth.view(),
          picture.normal.view(), picture.object_id.view(), picture.triangle_id.view()};
}

/// Renders into a picture that is given its size first.
Counters render_picture(Renderer::Buffers& buffers, Picture& picture, const Scene& scene,
                        const Camera& camera, const RenderSettings& settings) {
  const Rect rect = requested_rect(settings);
  const std::uint64_t need = picture_bytes(rect) + buffer_bytes(scene, settings, rect);
  const std::uint64_t left = memory_left(need, settings);
  return render_frame(buffers, scene, camera, settings, target_of(picture, rect), left);
}

}  // namespace

Renderer::Renderer() : buffers_(std::make_unique<Buffers>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Picture& Renderer::render(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  buffers_->picture.counters = render_picture(*buffers_, buffers_->picture, scene, camera, settings);
  return buffers_->picture;
}

Counters Renderer::render_into(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                               const PictureTarget& target) {
  const Rect rect = requested_rect(settings);
  const std::uint64_t left = memory_left(buffer_bytes(scene, settings, rect), settings);
  return render_frame(*buffers_, scene, camera, settings, target, left);
}

Picture render(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  Renderer::Buffers buffers;
  Picture picture;
  picture.counters = render_picture(buffers, picture, scene, camera, settings);
  return picture;
}

}  // namespace velum
