#include <glm/gtc/type_ptr.hpp>
#include <velum/pipeline/geometry_kernels.hpp>

#include "kernels.hpp"
#include "subject.hpp"

namespace velum_bench {
namespace {

using namespace velum;

/// The plain stages snap in set_up(), once per triangle; here once per vertex, as the kernels do.
void by_reference(benchmark::State& state, const Subject& subject) {
  ClipVertices out;
  std::vector<SnappedVertex> snapped(subject.mesh.positions.size());
  for (auto _ : state) {
    transform_vertices(subject.mesh.positions.span(), subject.clip_from_object, out);
    for (std::size_t i = 0; i < snapped.size(); ++i) {
      if (out.outcodes[i] == 0) snapped[i] = snap(out.positions[i], subject.viewport);
    }
    benchmark::DoNotOptimize(snapped.data());
    benchmark::ClobberMemory();
  }
}

void by_kernel(benchmark::State& state, const Subject& subject, Isa isa) {
  std::vector<PlacedVertex> placed(subject.mesh.positions.size());
  const TransformVertices transform = transform_kernel(isa);
  for (auto _ : state) {
    transform({&subject.mesh.positions[0].x, placed.size(), glm::value_ptr(subject.clip_from_object),
               subject.viewport.width, subject.viewport.height, nullptr, nullptr, placed.data(), nullptr});
    benchmark::ClobberMemory();
  }
}

}  // namespace

void register_transform() {
  register_kernel("transform", [](benchmark::State& state, const Subject& subject, Isa isa) {
    if (isa == Isa::reference) {
      by_reference(state, subject);
    } else {
      by_kernel(state, subject, isa);
    }
    count_items(state, subject.mesh.positions.size());
  });
}

}  // namespace velum_bench
