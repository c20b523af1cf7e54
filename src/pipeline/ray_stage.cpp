#include "ray_stage.hpp"

#include <algorithm>
#include <array>

#include "../base/error.hpp"
#include "../projection/facing.hpp"
#include "../visibility/depth_plane.hpp"
#include "stages.hpp"

namespace velum {
namespace {

/// Side of the rectangles that threads take, pixels.
constexpr int block_side = 32;
/// Rectangles between two reports of progress: threads wait for each other there.
constexpr int blocks_at_once = 512;

/// A picture's rectangles, row by row.
struct Blocks {
  Rect rect;
  int columns, rows;

  explicit Blocks(const Rect& rect_in)
      : rect(rect_in),
        columns((rect_in.width + block_side - 1) / block_side),
        rows((rect_in.height + block_side - 1) / block_side) {}

  Rect at(int row, int column) const {
    return intersect(rect,
                     {rect.left + column * block_side, rect.top + row * block_side, block_side, block_side});
  }
};

/// The depth of triangles at pixels; remembers the last one, which neighbours often share.
class Depths {
 public:
  Depths(const RayView& view, const RayStageInput& input) : view_(view), input_(input) {}

  float at(const SceneHit& hit, int x, int y) {
    if (hit.primitive != primitive_) set_up(hit);
    return plane_.at(x, y);
  }

 private:
  void set_up(const SceneHit& hit) {
    const std::array<glm::dvec4, 3> v = view_.clip_triangle(hit.instance, hit.triangle);
    plane_ = depth_plane(v, homogeneous_determinant(v[0], v[1], v[2]),
                         {input_.settings.width, input_.settings.height});
    if (input_.sample != pixel_centre) move_depth(plane_, input_.sample);
    primitive_ = hit.primitive;
  }

  const RayView& view_;
  const RayStageInput& input_;
  std::uint32_t primitive_ = no_primitive;
  DepthPlane plane_;
};

/// Rays through pixels next to each other are cast together.
constexpr int packet_width = 4, packet_height = 2;

/// A few pixels, row by row. @param pixels  at most a packet, inside input.rect
void cast_packet(const RayView& view, const RayStageInput& input, const Rect& pixels, Depths& depths,
                 VisibilityBuffer& buffer, CastCounters& counters) {
  const double dx = 0.5 + static_cast<double>(input.sample.x) / subpixels;
  const double dy = 0.5 + static_cast<double>(input.sample.y) / subpixels;
  std::array<ViewRay, packet_width * packet_height> rays;
  std::array<SceneHit, packet_width * packet_height> hits;
  std::size_t count = 0;
  for (int y = pixels.top; y < pixels.bottom(); ++y) {
    for (int x = pixels.left; x < pixels.right(); ++x) rays[count++] = view.rays().through(x + dx, y + dy);
  }
  view.first_hits({rays.data(), count}, {hits.data(), count}, counters);
  std::size_t i = 0;
  for (int y = pixels.top; y < pixels.bottom(); ++y) {
    for (int x = pixels.left; x < pixels.right(); ++x) {
      const SceneHit& hit = hits[i++];
      if (!hit.is_hit()) continue;
      buffer.reversed_depth.at(x - input.rect.left, y - input.rect.top) = depths.at(hit, x, y);
      buffer.primitive.at(x - input.rect.left, y - input.rect.top) = hit.primitive;
    }
  }
}

/// @return what it cost; counted here, not where other threads count next to it
CastCounters cast_block(const RayView& view, const RayStageInput& input, const Rect& block,
                        VisibilityBuffer& buffer) {
  CastCounters counters;
  Depths depths(view, input);
  for (int top = block.top; top < block.bottom(); top += packet_height) {
    for (int left = block.left; left < block.right(); left += packet_width) {
      cast_packet(view, input, intersect(block, {left, top, packet_width, packet_height}), depths, buffer,
                  counters);
    }
  }
  return counters;
}

/// The caller's, the last frame's, or a new one.
const SceneCaster& caster_for(const RayStageInput& input, RayStageBuffers& buffers) {
  const RenderSettings& settings = input.settings;
  if (settings.caster != nullptr) {
    if (settings.caster->is_of(input.scene)) return *settings.caster;
    throw Error(ErrorKind::usage, "was built for another scene, or before this one was changed",
                "RenderSettings::caster", "build a SceneCaster for this scene");
  }
  const SceneCaster* kept = buffers.caster.get();
  const bool is_kept = kept != nullptr && kept->kind() == settings.accelerator &&
                       kept->isa() == settings.isa && kept->is_of(input.scene);
  if (!is_kept) {
    buffers.caster = std::make_unique<SceneCaster>(input.scene, settings.accelerator, settings.isa);
  }
  return *buffers.caster;
}

void add(const CastCounters& cast, Counters& counters) {
  counters.rays += cast.rays;
  counters.ray_nodes += cast.nodes;
  counters.ray_boxes += cast.boxes;
  counters.ray_tests += cast.tests;
}

}  // namespace

RayView::RayView(const Scene& scene, const SceneCaster& caster, const ViewingTransform& viewing,
                 const RenderSettings& settings)
    : scene_(scene),
      caster_(caster),
      cull_(settings.cull),
      rays_(viewing, {settings.width, settings.height}) {
  for (const Instance& instance : scene.instances()) {
    clip_from_object_.push_back(viewing.clip_from_object(instance.world_from_object));
  }
}

std::array<glm::dvec4, 3> RayView::clip_triangle(std::uint32_t instance, std::uint32_t triangle) const {
  const Mesh& mesh = scene_.meshes()[scene_.instances()[instance].mesh];
  const glm::uvec3& v = mesh.triangles[triangle];
  const glm::dmat4& matrix = clip_from_object_[instance];
  return {clip_position(matrix, mesh.positions[v.x]), clip_position(matrix, mesh.positions[v.y]),
          clip_position(matrix, mesh.positions[v.z])};
}

bool RayView::is_culled(std::uint32_t instance, std::uint32_t triangle) const {
  if (cull_ == Cull::none) return false;
  const std::array<glm::dvec4, 3> v = clip_triangle(instance, triangle);
  const bool mirrored = is_mirroring(scene_.instances()[instance].world_from_object);
  const Facing facing = facing_of(homogeneous_determinant(v[0], v[1], v[2]), mirrored);
  return facing == (cull_ == Cull::back ? Facing::back : Facing::front);
}

SceneFilter RayView::filter() const {
  if (cull_ == Cull::none) return {};
  return {[](const void* self, std::uint32_t instance, std::uint32_t triangle) {
            return !static_cast<const RayView*>(self)->is_culled(instance, triangle);
          },
          this};
}

SceneHit RayView::at(double px, double py, CastCounters& counters) const {
  const ViewRay view_ray = rays_.through(px, py);
  return caster_.first_hit(view_ray.ray, view_ray.range, counters, filter());
}

void RayView::first_hits(std::span<const ViewRay> rays, std::span<SceneHit> hits,
                         CastCounters& counters) const {
  caster_.first_hits(rays, hits, counters, filter());
}

void cast_visibility(const RayStageInput& input, const std::function<void(double)>& progress,
                     RayStageBuffers& buffers, VisibilityBuffer& buffer, Counters& counters) {
  const RayView view(input.scene, caster_for(input, buffers), input.viewing, input.settings);
  for (const Instance& instance : input.scene.instances()) {
    ++counters.instances;
    counters.triangles += input.scene.meshes()[instance.mesh].triangles.size();
  }
  const Blocks blocks(input.rect);
  std::vector<CastCounters> of_worker(static_cast<std::size_t>(input.executor.threads()));
  const int rows_at_once = std::max(1, blocks_at_once / std::max(1, blocks.columns));
  for (int row = 0, next = 0; row < blocks.rows; row = next) {
    next = std::min(blocks.rows, row + rows_at_once);
    const auto count = static_cast<std::size_t>(next - row) * static_cast<std::size_t>(blocks.columns);
    input.executor.for_each(count, [&](std::size_t i, int worker) {
      const int block = static_cast<int>(i);
      of_worker[static_cast<std::size_t>(worker)] +=
          cast_block(view, input, blocks.at(row + block / blocks.columns, block % blocks.columns), buffer);
    });
    progress(static_cast<double>(next) / blocks.rows);
  }
  for (const CastCounters& cast : of_worker) add(cast, counters);
}

}  // namespace velum
