#include "render.hpp"

#include <algorithm>
#include <memory>

#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "check_request.hpp"
#include "shade_stage.hpp"
#include "stages.hpp"

namespace velum {

/// What a Renderer keeps between frames.
struct Renderer::Buffers {
  ClipVertices vertices;
  std::vector<ScreenTriangle> screen_triangles;
  ScanlineTables scanline;
  VisibilityBuffer visibility;
  LayerBuffers layers;
  Picture picture;
};

namespace {

/// Triangles set up before they are handed to the raster: enough to amortise, few enough to stay in cache.
constexpr std::uint32_t batch_size = 4096;

void report_progress(const RenderSettings& settings, double share) {
  if (settings.progress && !settings.progress(share)) {
    throw Error(ErrorKind::cancelled, "rendering was cancelled by its progress callback");
  }
}

void add(const RasterCounts& raster, Counters& counters) {
  counters.zero_area += raster.zero_area;
  counters.pixels_tested += raster.pixels_tested;
  counters.spans += raster.spans;
  counters.fragments += raster.fragments;
  counters.fragments_written += raster.fragments_written;
}

/// One frame, from the scene to the visibility buffer.
struct Frame {
  const Scene& scene;
  const RenderSettings& settings;
  const ViewingTransform& viewing;
  Rect rect;
  Renderer::Buffers& buffers;
  Counters& counters;
  const VisibilityBuffer* previous = nullptr;  ///< depth peeling: the layer in front
  double progress_from = 0.0;
  double progress_to = 0.8;

  void draw_batch(const Mesh& mesh, std::uint32_t first, std::uint32_t last, std::uint32_t first_primitive,
                  bool mirrored) {
    const Viewport viewport{settings.width, settings.height};
    buffers.screen_triangles.clear();
    for (std::uint32_t i = first; i < last; ++i) {
      const AssembledTriangle triangle =
          assemble(buffers.vertices, mesh.triangles[i], mirrored, settings.cull, counters);
      if (triangle.fate == TriangleFate::accepted || triangle.fate == TriangleFate::to_clip) {
        set_up(triangle, first_primitive + i, viewport, counters, buffers.screen_triangles);
      }
    }
    const RasterTarget target{buffers.visibility, rect, previous, settings.depth_format};
    add(rasterize(buffers.screen_triangles, target, settings, buffers.scanline), counters);
  }

  void draw_instance(std::uint32_t index) {
    const Instance& instance = scene.instances()[index];
    const Mesh& mesh = scene.meshes()[instance.mesh];
    transform_vertices(mesh.positions.span(), viewing.clip_from_object(instance.world_from_object),
                       buffers.vertices);
    ++counters.instances;
    counters.vertices += mesh.positions.size();
    const std::uint32_t first_primitive = scene.first_primitive(index);
    const bool mirrored = is_mirroring(instance.world_from_object);
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    for (std::uint32_t first = 0, last = 0; last < count; first = last) {
      last = first + std::min(batch_size, count - first);
      draw_batch(mesh, first, last, first_primitive, mirrored);
      const double drawn = static_cast<double>(first_primitive + last) / scene.primitive_count();
      report_progress(settings, progress_from + (progress_to - progress_from) * drawn);
    }
  }

  void draw_scene() {
    buffers.visibility.clear(rect.width, rect.height);
    for (std::uint32_t i = 0; i < scene.instances().size(); ++i) draw_instance(i);
  }
};

/// Bytes of the visibility buffer per pixel.
constexpr std::uint64_t visibility_bytes = sizeof(float) + sizeof(std::uint32_t);
/// Bytes of all of a Picture's outputs per pixel.
constexpr std::uint64_t picture_bytes =
    sizeof(Rgba8) + 2 * sizeof(float) + sizeof(glm::vec3) + 2 * sizeof(std::uint32_t);

std::uint64_t pixel_count(const Rect& rect) {
  return static_cast<std::uint64_t>(rect.width) * static_cast<std::uint64_t>(rect.height);
}

/// Makes the layer just shown the one to peel off; a closed pixel counts as exhausted, so nothing more is
/// drawn there.
void exhaust_closed_pixels(Renderer::Buffers& buffers) {
  LayerBuffers& layers = buffers.layers;
  std::swap(layers.previous, buffers.visibility);
  for (int y = 0; y < layers.previous.height(); ++y) {
    for (int x = 0; x < layers.previous.width(); ++x) {
      if (layers.is_open.at(x, y)) continue;
      layers.previous.reversed_depth.at(x, y) = 0.0f;
      layers.previous.primitive.at(x, y) = no_primitive;
    }
  }
}

Counters render_frame(Renderer::Buffers& buffers, const Scene& scene, const Camera& camera,
                      const RenderSettings& settings, const PictureTarget& target) {
  const FloatingPointScope floating_point;
  const Rect rect = requested_rect(settings);
  check_method(settings);
  const ViewingTransform viewing = requested_view(camera, settings);
  check_target(target, rect);
  Counters counters;
  Frame{scene, settings, viewing, rect, buffers, counters}.draw_scene();
  ShadeStage stage({scene, camera, viewing, settings, rect}, target, buffers.layers);
  stage.shade_first_layer(buffers.visibility, counters);
  while (stage.open_pixels() > 0 && (settings.layers == 0 || counters.layers < settings.layers)) {
    exhaust_closed_pixels(buffers);
    Counters raster_again;  // the geometry is counted once
    const auto layer = static_cast<double>(counters.layers);
    Frame{scene,
          settings,
          viewing,
          rect,
          buffers,
          raster_again,
          &buffers.layers.previous,
          1.0 - 0.2 / layer,
          1.0 - 0.2 / (layer + 1.0)}
        .draw_scene();
    stage.shade_next_layer(buffers.visibility, counters);
  }
  stage.finish();
  report_progress(settings, 1.0);
  return counters;
}

/// Gives the picture its size and returns views of all its outputs.
PictureTarget target_of(Picture& picture, const Rect& rect) {
  picture.colour.resize(rect.width, rect.height);
  picture.depth.resize(rect.width, rect.height);
  picture.metric_depth.resize(rect.width, rect.height);
  picture.normal.resize(rect.width, rect.height);
  picture.object_id.resize(rect.width, rect.height);
  picture.triangle_id.resize(rect.width, rect.height);
  return {picture.colour.view(), picture.depth.view(),     picture.metric_depth.view(),
          picture.normal.view(), picture.object_id.view(), picture.triangle_id.view()};
}

}  // namespace

Renderer::Renderer() : buffers_(std::make_unique<Buffers>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Picture& Renderer::render(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  const Rect rect = requested_rect(settings);
  check_memory(pixel_count(rect) * (visibility_bytes + picture_bytes), settings);
  const PictureTarget target = target_of(buffers_->picture, rect);
  buffers_->picture.counters = render_frame(*buffers_, scene, camera, settings, target);
  return buffers_->picture;
}

Counters Renderer::render_into(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                               const PictureTarget& target) {
  check_memory(pixel_count(requested_rect(settings)) * visibility_bytes, settings);
  return render_frame(*buffers_, scene, camera, settings, target);
}

Picture render(const Scene& scene, const Camera& camera, const RenderSettings& settings) {
  const Rect rect = requested_rect(settings);
  check_memory(pixel_count(rect) * (visibility_bytes + picture_bytes), settings);
  Picture picture;
  const PictureTarget target = target_of(picture, rect);
  picture.counters = Renderer().render_into(scene, camera, settings, target);
  return picture;
}

}  // namespace velum
