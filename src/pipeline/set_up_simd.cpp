#include "geometry_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/set_up_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"
#include "set_up_bounds-inl.hpp"
#include "set_up_large-inl.hpp"
#include "set_up_small-inl.hpp"
#include "set_up_tiny-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// What the passes over a chunk hand on; overwritten chunk by chunk.
struct Passes {
  Chunk chunk;
  ChunkList slow;
  LargeList large;
  SmallList small;
  TinyArrays tiny;
  FetchedVertices vertices;
  PlaneArrays depth;
};

/// Lanes behind the last triangle are computed, never used; what they hold must be numbers.
void clear(Passes& passes) {
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t i = 0; i < 2 * chunk_room; ++i) passes.chunk.xy[v][i] = 0;
    for (std::size_t i = 0; i < 4 * chunk_room; ++i) passes.vertices.position[v][i] = 0.0f;
    for (std::size_t i = 0; i < chunk_room; ++i) passes.large.x[v][i] = passes.large.y[v][i] = 0;
  }
}

void set_up_chunk(const SetUpWork& work, Passes& p, BoxLanes& box, SetUpResult& result, Counters& counters) {
  p.slow.count = p.large.list.count = p.small.list.count = p.tiny.list.count = 0;
  classify(work, p.chunk, p.slow, p.large, p.small, p.tiny, box, counters);
  for (std::size_t i = 0; i < p.slow.count; ++i) work.slow[result.slow++] = p.chunk.triangle(p.slow.place[i]);
  if (p.large.list.count > 0) set_up_large(work, p.chunk, p.large, p.vertices, p.depth, result, counters);
  if (p.small.list.count > 0) {
    write_bounds(work, p.chunk, p.small, result.small);
    result.small += p.small.list.count;
  }
  if (p.tiny.list.count > 0) {
    fetch_vertices(work, p.chunk, p.tiny.list, p.vertices);
    set_up_depths(work, p.vertices, p.tiny.list.count, p.depth);
    result.fragments += write_fragments(work, p.chunk, p.tiny, p.depth, result.fragments);
  }
}

}  // namespace

SetUpResult set_up_triangles(const SetUpWork& work, Counters& counters) {
  SetUpResult result{};
  Passes passes;
  clear(passes);
  BoxLanes box = no_box();
  for (std::uint32_t next = work.first; next < work.last; next += chunk_size) {
    fetch(work, next, passes.chunk);
    set_up_chunk(work, passes, box, result, counters);
  }
  result.box = united(result.box, box_of(box));
  return result;
}

void set_up_small(const void* given, const std::uint32_t* triangles, std::size_t count, SmallTriangle* out) {
  const SetUpWork& work = *static_cast<const SetUpWork*>(given);
  SmallPasses passes;
  std::uint32_t numbers[chunk_size];
  for (std::size_t first = 0; first < count; first += chunk_size) {
    const std::size_t here = HWY_MIN(chunk_size, count - first);
    for (std::size_t i = 0; i < here; ++i) numbers[i] = work.first + triangles[first + i];
    set_up_few(work, numbers, here, passes, out + first);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

SetUpTriangles set_up_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(set_up_triangles);
  return versions.at(isa);
}

SmallSource::SetUp set_up_small_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(set_up_small);
  return versions.at(isa);
}

}  // namespace velum
#endif
