#include "frame.hpp"

#include <algorithm>

#include "../base/error.hpp"
#include "crop_rejection.hpp"
#include "line_stages.hpp"

namespace velum {
namespace {

/// Triangles set up before they are handed to the raster: enough to amortise, few enough to stay in cache.
constexpr std::uint32_t batch_size = 4096;

void add(const RasterCounts& raster, Counters& counters) {
  counters.zero_area += raster.zero_area;
  counters.pixels_tested += raster.pixels_tested;
  counters.spans += raster.spans;
  counters.fragments += raster.fragments;
  counters.fragments_written += raster.fragments_written;
}

}  // namespace

void report_progress(const RenderSettings& settings, double share) {
  if (settings.progress && !settings.progress(share)) {
    throw Error(ErrorKind::cancelled, "rendering was cancelled by its progress callback");
  }
}

/// Hands `count` primitives to the raster, batch by batch.
/// @param set_up_one  appends the screen triangles of primitive i
template <typename SetUp>
void Frame::draw(std::size_t count, std::uint32_t first_primitive, const SetUp& set_up_one) {
  for (std::size_t first = 0, last = 0; first < count; first = last) {
    last = first + std::min<std::size_t>(batch_size, count - first);
    buffers.screen_triangles.clear();
    for (std::size_t i = first; i < last; ++i) {
      set_up_one(i, first_primitive + static_cast<std::uint32_t>(i), buffers.screen_triangles);
    }
    move_all_to(sample, buffers.screen_triangles);
    const RasterTarget target{buffers.visibility, rect, lists, settings.depth_format};
    add(rasterize(buffers.screen_triangles, target, settings, buffers.scanline), counters);
    const double drawn = (first_primitive + static_cast<double>(last)) / scene.primitive_count();
    report_progress(settings, progress_from + (progress_to - progress_from) * drawn);
  }
}

void Frame::draw_triangles(const Mesh& mesh, std::uint32_t first_primitive, bool mirrored) {
  draw(mesh.triangles.size(), first_primitive, [&](std::size_t i, std::uint32_t primitive, auto& out) {
    const AssembledTriangle triangle = assemble(buffers.vertices, mesh.triangles[i], mirrored, settings.cull,
                                                clip_volume_of(settings), counters);
    if (triangle.fate == TriangleFate::accepted || triangle.fate == TriangleFate::to_clip) {
      set_up(triangle, primitive, viewport(), counters, out);
    }
  });
}

void Frame::draw_lines(const Mesh& mesh, std::uint32_t first_primitive) {
  first_primitive += static_cast<std::uint32_t>(mesh.triangles.size());
  draw(mesh.segments.size(), first_primitive, [&](std::size_t i, std::uint32_t primitive, auto& out) {
    set_up_segment(buffers.vertices, mesh.segments[i], primitive, settings.line_width, viewport(), counters,
                   out);
  });
  first_primitive += static_cast<std::uint32_t>(mesh.segments.size());
  draw(mesh.points.size(), first_primitive, [&](std::size_t i, std::uint32_t primitive, auto& out) {
    set_up_point(buffers.vertices, mesh.points[i], primitive, settings.point_size, viewport(), counters, out);
  });
}

void Frame::draw_instance(std::uint32_t index) {
  const Instance& instance = scene.instances()[index];
  const Mesh& mesh = scene.meshes()[instance.mesh];
  const glm::dmat4 clip_from_object = viewing.clip_from_object(instance.world_from_object);
  if (is_beside(scene, index, clip_from_object, settings, within)) {
    ++counters.instances_beside;
    return;
  }
  transform_vertices(mesh.positions.span(), clip_from_object, buffers.vertices);
  ++counters.instances;
  counters.vertices += mesh.positions.size();
  draw_triangles(mesh, scene.first_primitive(index), is_mirroring(instance.world_from_object));
  draw_lines(mesh, scene.first_primitive(index));
}

bool Frame::is_for_kernels() const {
  const bool has_kernels = settings.visibility == VisibilityMethod::zbuffer ||
                           settings.visibility == VisibilityMethod::hierarchical;
  return has_kernels && settings.isa != Isa::reference && settings.depth_format == DepthFormat::reversed &&
         lists == nullptr;
}

bool Frame::is_for_hierarchy() const {
  return settings.visibility == VisibilityMethod::hierarchical && lists == nullptr && sample == pixel_centre;
}

/// Segments and points alone: for methods that know only triangles.
void Frame::draw_lines_of_all() {
  for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
    const Instance& instance = scene.instances()[i];
    const Mesh& mesh = scene.meshes()[instance.mesh];
    if (mesh.segments.empty() && mesh.points.empty()) continue;
    transform_vertices(mesh.positions.span(), viewing.clip_from_object(instance.world_from_object),
                       buffers.vertices);
    draw_lines(mesh, scene.first_primitive(i));
  }
}

void Frame::draw_scene() {
  const std::function<void(double)> progress = [this](double drawn) {
    report_progress(settings, progress_from + (progress_to - progress_from) * drawn);
  };
  const TileStageInput input{scene,    viewing, settings, rect,  buffers.executor,
                             progress, sample,  sink,     within};
  if (is_for_tiles()) {
    draw_in_tiles(input, buffers.tiles, buffers.visibility, counters);
    return;
  }
  if (lists == nullptr) buffers.visibility.clear(rect.width, rect.height);
  if (settings.visibility == VisibilityMethod::raycast && lists == nullptr) {
    cast_visibility({scene, viewing, settings, rect, buffers.executor, sample}, progress, buffers.rays,
                    buffers.visibility, counters);
    return draw_lines_of_all();
  }
  if (is_for_hierarchy()) {
    draw_hierarchically(input, is_for_kernels(), buffers.hierarchy, buffers.visibility, counters);
    return draw_lines_of_all();
  }
  for (std::uint32_t i = 0; i < scene.instances().size(); ++i) draw_instance(i);
}

}  // namespace velum
