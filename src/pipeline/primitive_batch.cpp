#include "primitive_batch.hpp"

#include <glm/gtc/type_ptr.hpp>

#include "line_stages.hpp"

namespace velum {
namespace {

/// A run with all that belongs to it.
struct RunSetUp {
  const BatchInput& input;
  const PlacedVertices& vertices;
  const PrimitiveRun& run;
  Counters& counters;
  ScreenPrimitives& out;
  BatchScratch& scratch;
  const Instance& instance = input.scene.instances()[run.instance];
  const Mesh& mesh = input.scene.meshes()[instance.mesh];
  const std::uint32_t first_primitive = input.scene.primitive({run.instance, 0, run.kind});
  const Viewport viewport{input.settings.width, input.settings.height};

  SetUpWork work() const {
    const Rect& target = input.grid.target;
    SetUpWork work{};
    work.indices = &mesh.triangles[0].x;
    work.first = run.first;
    work.last = run.last;
    work.first_primitive = first_primitive;
    work.positions = &mesh.positions[0].x;
    work.clip_from_object = glm::value_ptr(vertices.clip_from_object);
    work.placed = vertices.placed.data();
    work.width = viewport.width;
    work.height = viewport.height;
    work.target_left = target.left;
    work.target_top = target.top;
    work.target_right = target.right();
    work.target_bottom = target.bottom();
    work.tile_columns = input.grid.columns;
    work.sample_x = static_cast<float>(input.sample.x) / subpixels;
    work.sample_y = static_cast<float>(input.sample.y) / subpixels;
    set_culling(work, input.settings.cull, is_mirroring(instance.world_from_object));
    work.large = out.large.data() + out.large_count;
    work.small = out.small.data() + out.small_count;
    work.fragments = out.fragments.data() + out.fragment_count;
    work.slow = scratch.slow.data();
    return work;
  }

  void set_up_triangles() {
    scratch.slow.make_room(run.count());
    out.make_room(run.count());
    const SetUpResult result = input.set_up(work(), counters);
    out.large_count += result.large;
    out.small_count += result.small;
    out.fragment_count += result.fragments;
    out.box = united(out.box, result.box);
    set_up_slow_triangles(result.slow);
  }

  std::array<glm::dvec4, 3> clip_triangle_of(const glm::uvec3& indices) const {
    const auto vertex = [&](std::uint32_t i) {
      return clip_position(vertices.clip_from_object, mesh.positions[i]);
    };
    return {vertex(indices.x), vertex(indices.y), vertex(indices.z)};
  }

  /// Those that need clipping, by the plain stages.
  void set_up_slow_triangles(std::size_t count) {
    const bool mirrored = is_mirroring(instance.world_from_object);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t index = scratch.slow[i];
      const AssembledTriangle triangle =
          assemble(clip_triangle_of(mesh.triangles[index]), mirrored, input.settings.cull,
                   clip_volume_of(input.settings), counters);
      if (triangle.fate == TriangleFate::accepted || triangle.fate == TriangleFate::to_clip) {
        set_up(triangle, first_primitive + index, viewport, counters, scratch.screen_triangles);
      }
    }
  }

  void set_up_segments() {
    for (std::uint32_t i = run.first; i < run.last; ++i) {
      set_up_segment(vertices.clip, mesh.segments[i], first_primitive + i, input.settings.line_width,
                     viewport, counters, scratch.screen_triangles);
    }
  }

  void set_up_points() {
    for (std::uint32_t i = run.first; i < run.last; ++i) {
      set_up_point(vertices.clip, mesh.points[i], first_primitive + i, input.settings.point_size, viewport,
                   counters, scratch.screen_triangles);
    }
  }

  void set_up_run() {
    switch (run.kind) {
      case PrimitiveKind::triangle:
        return set_up_triangles();
      case PrimitiveKind::segment:
        return set_up_segments();
      case PrimitiveKind::point:
        return set_up_points();
    }
  }
};

}  // namespace

void BatchScratch::make_room_like(const BatchScratch& other) {
  slow.make_room(other.slow.room());
  screen_triangles.reserve(other.screen_triangles.capacity());
}

void set_culling(SetUpWork& work, Cull cull, bool mirrored) {
  work.is_back_positive = mirrored;
  const bool culls_back = cull == Cull::back;
  const bool culls_front = cull == Cull::front;
  work.cull_positive = mirrored ? culls_back : culls_front;
  work.cull_negative = mirrored ? culls_front : culls_back;
  work.cull_zero = culls_front;  // edge-on counts as front-facing
}

void set_up_batch(const BatchInput& input, std::span<const PlacedVertices> vertices, PrimitiveBatch& batch,
                  BatchScratch& scratch) {
  batch.counters = {};
  batch.primitives.clear();
  batch.primitives.make_room(batch.count);
  for (const PrimitiveRun& run : batch.runs) {
    scratch.screen_triangles.clear();
    RunSetUp{input, vertices[run.vertices], run, batch.counters, batch.primitives, scratch}.set_up_run();
    move_all_to(input.sample, scratch.screen_triangles);
    for (const ScreenTriangle& triangle : scratch.screen_triangles) {
      if (!append_triangle(triangle, input.grid, batch.primitives)) ++batch.counters.zero_area;
    }
  }
  batch.bins.sort(batch.primitives, input.grid);
}

}  // namespace velum
