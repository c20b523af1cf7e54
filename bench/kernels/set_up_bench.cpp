#include <glm/gtc/type_ptr.hpp>
#include <velum/pipeline/primitive_batch.hpp>
#include <velum/visibility/screen_primitives.hpp>

#include "kernels.hpp"
#include "subject.hpp"

namespace velum_bench {
namespace {

using namespace velum;

void by_reference(benchmark::State& state, const Subject& subject) {
  ClipVertices vertices;
  transform_vertices(subject.mesh.positions.span(), subject.clip_from_object, vertices);
  std::vector<ScreenTriangle> out;
  for (auto _ : state) {
    out.clear();
    assemble_and_set_up(vertices, subject, out);
    benchmark::ClobberMemory();
  }
}

struct Placed {
  std::vector<PlacedVertex> vertices;
  std::vector<float> nearness;
};

Placed placed_by_kernel(const Subject& subject, Isa isa) {
  const std::size_t count = subject.mesh.positions.size();
  Placed placed{std::vector<PlacedVertex>(count), std::vector<float>(count)};
  transform_kernel(isa)({&subject.mesh.positions[0].x, count, glm::value_ptr(subject.clip_from_object),
                         subject.viewport.width, subject.viewport.height, nullptr, nullptr,
                         placed.vertices.data(), placed.nearness.data()});
  return placed;
}

SetUpWork work_of(const Subject& subject, const Placed& placed) {
  const Rect rect = subject.rect();
  SetUpWork work{};
  work.indices = &subject.mesh.triangles[0].x;
  work.positions = &subject.mesh.positions[0].x;
  work.clip_from_object = glm::value_ptr(subject.clip_from_object);
  work.placed = placed.vertices.data();
  work.nearness = placed.nearness.data();
  work.width = rect.width;
  work.height = rect.height;
  work.target_right = rect.right();
  work.target_bottom = rect.bottom();
  work.tile_columns = TileGrid(rect).columns;
  set_culling(work, Cull::none, false);
  return work;
}

void by_kernel(benchmark::State& state, const Subject& subject, Isa isa) {
  constexpr std::uint32_t batch = 4096;  // as many as stay in cache, like a frame's batches
  const Placed placed = placed_by_kernel(subject, isa);
  ScreenPrimitives out;
  out.make_room(batch);
  out.make_room_for_ready(batch);
  std::vector<std::uint32_t> slow(batch);
  SetUpWork work = work_of(subject, placed);
  work.large = out.large.data();
  work.small_bounds = out.small_bounds.data();
  work.small_refs = out.small_refs.data();
  work.fragments = out.fragments.from(0);
  work.slow = slow.data();
  const SetUpTriangles set_up = set_up_kernel(isa);
  const SmallSource::SetUp set_up_small = set_up_small_kernel(isa);
  const auto count = static_cast<std::uint32_t>(subject.mesh.triangles.size());
  Counters counters;
  for (auto _ : state) {
    for (work.first = 0; work.first < count; work.first = work.last) {
      work.last = std::min(count, work.first + batch);
      const SetUpResult result = set_up(work, counters);
      set_up_small(&work, out.small_refs.data(), result.small, out.small.data());
    }
    benchmark::ClobberMemory();
  }
}

}  // namespace

void register_set_up() {
  register_kernel("set_up", [](benchmark::State& state, const Subject& subject, Isa isa) {
    if (isa == Isa::reference) {
      by_reference(state, subject);
    } else {
      by_kernel(state, subject, isa);
    }
    count_items(state, subject.mesh.triangles.size());
  });
}

}  // namespace velum_bench
