#include "primitive_batch.hpp"

#include <glm/gtc/type_ptr.hpp>

#include "line_stages.hpp"

namespace velum {
namespace {

/// Of fewer triangles small ones are set up at once: one by one, from here and there, they would cost more
/// than is saved where they are hidden.
constexpr std::uint32_t fewest_to_wait = 16;

/// What the kernel is told of the triangles.
SetUpWork work_of(const BatchInput& input, const TriangleList& triangles, ScreenPrimitives& out,
                  BatchScratch& scratch) {
  const Rect& target = input.grid.target;
  SetUpWork work{};
  work.indices = triangles.indices;
  work.first = triangles.first;
  work.last = triangles.last;
  work.first_primitive = triangles.first_primitive;
  work.primitives = triangles.primitives;
  work.positions = &triangles.positions->x;
  work.clip_from_object = glm::value_ptr(triangles.clip_from_object);
  work.placed = triangles.placed;
  work.nearness = triangles.nearness;
  work.width = input.settings.width;
  work.height = input.settings.height;
  work.target_left = target.left;
  work.target_top = target.top;
  work.target_right = target.right();
  work.target_bottom = target.bottom();
  work.tile_columns = input.grid.columns;
  work.sample_x = static_cast<float>(input.sample.x) / subpixels;
  work.sample_y = static_cast<float>(input.sample.y) / subpixels;
  set_culling(work, input.settings.cull, triangles.is_mirrored);
  work.large = out.large.data() + out.large_count;
  work.small_bounds = out.small_bounds.data() + out.small_count;
  work.small_refs = out.small_refs.data() + out.small_count;
  work.first_ref = out.next_ref();
  work.fragments = out.fragments.from(out.fragment_count);
  work.slow = scratch.slow.data();
  return work;
}

/// Sets up what the kernel found to be small, behind the first small_count. @param work  what the kernel was
/// told
void set_up_small_at_once(const BatchInput& input, const SetUpWork& work, std::size_t count,
                          ScreenPrimitives& out) {
  out.make_room_for_ready(count);
  SmallTriangle* const ready = out.small.data() + out.ready_count;
  std::uint32_t* const refs = out.small_refs.data() + out.small_count;
  for (std::size_t i = 0; i < count; ++i) refs[i] -= work.first_ref;
  input.set_up_small(&work, refs, count, ready);
  for (std::size_t i = 0; i < count; ++i) {
    out.small_bounds[out.small_count + i].nearest = ready[i].upper;
    refs[i] = ready_small | static_cast<std::uint32_t>(out.ready_count + i);
  }
  out.ready_count += count;
}

/// The first `count` triangles of scratch.slow, by the plain stages.
void set_up_slow(const BatchInput& input, const TriangleList& triangles, std::size_t count,
                 BatchScratch& scratch, Counters& counters) {
  const Viewport viewport{input.settings.width, input.settings.height};
  const auto vertex = [&](std::uint32_t i) {
    return clip_position(triangles.clip_from_object, triangles.positions[i]);
  };
  for (std::size_t next = 0; next < count; ++next) {
    const std::uint32_t i = scratch.slow[next];
    const std::uint32_t* const corner = triangles.indices + 3 * static_cast<std::size_t>(i);
    const AssembledTriangle triangle =
        assemble({vertex(corner[0]), vertex(corner[1]), vertex(corner[2])}, triangles.is_mirrored,
                 input.settings.cull, clip_volume_of(input.settings), counters);
    if (triangle.fate == TriangleFate::accepted || triangle.fate == TriangleFate::to_clip) {
      set_up(triangle, triangles.primitive(i), viewport, counters, scratch.screen_triangles);
    }
  }
}

/// Appends scratch.screen_triangles as the sample sees them, and empties it.
void append_screen_triangles(const BatchInput& input, ScreenPrimitives& out, BatchScratch& scratch,
                             Counters& counters) {
  move_all_to(input.sample, scratch.screen_triangles);
  for (const ScreenTriangle& triangle : scratch.screen_triangles) {
    if (!append_triangle(triangle, input.grid, out)) ++counters.zero_area;
  }
  scratch.screen_triangles.clear();
}

/// A run with all that belongs to it.
struct RunSetUp {
  const BatchInput& input;
  const PlacedVertices& vertices;
  const PrimitiveRun& run;
  Counters& counters;
  SetUpWork& work;
  ScreenPrimitives& out;
  BatchScratch& scratch;
  const Instance& instance = input.scene.instances()[run.instance];
  const Mesh& mesh = input.scene.meshes()[instance.mesh];
  const std::uint32_t first_primitive = input.scene.primitive({run.instance, 0, run.kind});
  const Viewport viewport{input.settings.width, input.settings.height};

  void set_up_run_triangles() {
    set_up_triangles(input,
                     {&mesh.triangles[0].x, run.first, run.last, first_primitive, nullptr, &mesh.positions[0],
                      vertices.placed, vertices.nearness, vertices.clip_from_object,
                      is_mirroring(instance.world_from_object)},
                     work, out, scratch, counters);
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
        return set_up_run_triangles();
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

void set_up_triangles(const BatchInput& input, const TriangleList& triangles, SetUpWork& work,
                      ScreenPrimitives& out, BatchScratch& scratch, Counters& counters) {
  scratch.slow.make_room(triangles.count());
  out.make_room(triangles.count());
  work = work_of(input, triangles, out, scratch);
  const SetUpResult result = input.set_up(work, counters);
  if (triangles.nearness == nullptr || triangles.count() < fewest_to_wait) {
    set_up_small_at_once(input, work, result.small, out);
  } else {
    out.sources.push_back({input.set_up_small, &work, work.first_ref, work.first_ref + triangles.count()});
  }
  out.large_count += result.large;
  out.small_count += result.small;
  out.fragment_count += result.fragments;
  out.box = united(out.box, result.box);
  scratch.screen_triangles.clear();
  set_up_slow(input, triangles, result.slow, scratch, counters);
  append_screen_triangles(input, out, scratch, counters);
}

void set_up_batch(const BatchInput& input, const std::deque<PlacedVertices>& vertices, PrimitiveBatch& batch,
                  BatchScratch& scratch) {
  batch.counters = {};
  batch.primitives.clear();
  batch.primitives.make_room(batch.count);
  scratch.screen_triangles.clear();
  batch.works.resize(batch.runs.size());
  for (std::size_t i = 0; i < batch.runs.size(); ++i) {
    const PrimitiveRun& run = batch.runs[i];
    RunSetUp{input, vertices[run.vertices], run, batch.counters, batch.works[i], batch.primitives, scratch}
        .set_up_run();
    append_screen_triangles(input, batch.primitives, scratch, batch.counters);
  }
  batch.bins.sort(batch.primitives, input.grid);
}

}  // namespace velum
