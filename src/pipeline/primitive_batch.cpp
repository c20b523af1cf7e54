#include "primitive_batch.hpp"

#include "line_stages.hpp"

namespace velum {
namespace {

void add(const SetUpCounts& counts, Counters& counters) {
  counters.triangles += counts.accepted + counts.culled;
  counters.trivially_accepted += counts.accepted;
  counters.back_facing += counts.back_facing;
  counters.edge_on += counts.edge_on;
  counters.culled += counts.culled;
  counters.screen_triangles += counts.screen_triangles;
  counters.zero_area += counts.zero_area;
  counters.reversed += counts.reversed;
}

/// A batch with all that belongs to it.
struct BatchSetUp {
  const BatchInput& input;
  const PlacedVertices& vertices;
  PrimitiveBatch& batch;
  std::vector<ScreenTriangle>& screen_triangles;
  const Instance& instance = input.scene.instances()[batch.instance];
  const Mesh& mesh = input.scene.meshes()[instance.mesh];
  const std::uint32_t first_primitive = input.scene.primitive({batch.instance, 0, batch.kind});
  const Viewport viewport{input.settings.width, input.settings.height};

  /// The triangles that need no clipping, by the vector kernel.
  void set_up_whole_triangles() {
    const Rect& target = input.grid.target;
    const std::uint32_t count = batch.last - batch.first;
    batch.bins.triangles.resize(count);
    batch.slow.resize(count);
    SetUpWork work{};
    work.indices = &mesh.triangles[0].x;
    work.first = batch.first;
    work.last = batch.last;
    work.first_primitive = first_primitive;
    work.clip = &vertices.clip.positions[0].x;
    work.placed = vertices.placed.data();
    work.width = viewport.width;
    work.height = viewport.height;
    work.target_left = target.left;
    work.target_top = target.top;
    work.target_right = target.right();
    work.target_bottom = target.bottom();
    set_culling(work, input.settings.cull, is_mirroring(instance.world_from_object));
    work.out = batch.bins.triangles.data();
    work.slow = batch.slow.data();
    SetUpCounts counts;
    const SetUpResult result = input.set_up(work, counts);
    batch.bins.triangles.resize(result.triangles);
    batch.slow.resize(result.slow);
    add(counts, batch.counters);
  }

  /// The others, by the plain stages.
  void set_up_slow_triangles() {
    const bool mirrored = is_mirroring(instance.world_from_object);
    for (const std::uint32_t i : batch.slow) {
      const AssembledTriangle triangle =
          assemble(vertices.clip, mesh.triangles[i], mirrored, input.settings.cull, batch.counters);
      if (triangle.fate == TriangleFate::accepted || triangle.fate == TriangleFate::to_clip) {
        set_up(triangle, first_primitive + i, viewport, batch.counters, screen_triangles);
      }
    }
  }

  void set_up_segments() {
    for (std::uint32_t i = batch.first; i < batch.last; ++i) {
      set_up_segment(vertices.clip, mesh.segments[i], first_primitive + i, input.settings.line_width,
                     viewport, batch.counters, screen_triangles);
    }
  }

  void set_up_points() {
    for (std::uint32_t i = batch.first; i < batch.last; ++i) {
      set_up_point(vertices.clip, mesh.points[i], first_primitive + i, input.settings.point_size, viewport,
                   batch.counters, screen_triangles);
    }
  }
};

}  // namespace

void PlacedVertices::resize(std::size_t count) {
  clip.positions.resize(count);
  clip.outcodes.resize(count);
  placed.resize(count);
}

void set_culling(SetUpWork& work, Cull cull, bool mirrored) {
  work.is_back_positive = mirrored;
  const bool culls_back = cull == Cull::back;
  const bool culls_front = cull == Cull::front;
  work.cull_positive = mirrored ? culls_back : culls_front;
  work.cull_negative = mirrored ? culls_front : culls_back;
  work.cull_zero = culls_front;  // edge-on counts as front-facing
}

void set_up_batch(const BatchInput& input, const PlacedVertices& vertices, PrimitiveBatch& batch,
                  std::vector<ScreenTriangle>& screen_triangles) {
  batch.counters = {};
  batch.bins.clear();
  screen_triangles.clear();
  BatchSetUp work{input, vertices, batch, screen_triangles};
  switch (batch.kind) {
    case PrimitiveKind::triangle:
      work.set_up_whole_triangles();
      work.set_up_slow_triangles();
      break;
    case PrimitiveKind::segment:
      work.set_up_segments();
      break;
    case PrimitiveKind::point:
      work.set_up_points();
      break;
  }
  if (input.sample != pixel_centre) {
    for (RasterTriangle& triangle : batch.bins.triangles) move_depth(triangle, input.sample);
    move_all_to(input.sample, screen_triangles);
  }
  for (const ScreenTriangle& triangle : screen_triangles) {
    if (!append_triangle(triangle, input.grid.target, batch.bins)) ++batch.counters.zero_area;
  }
  sort_into_tiles(input.grid, batch.bins);
}

}  // namespace velum
