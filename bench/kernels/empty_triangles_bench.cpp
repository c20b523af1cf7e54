#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <velum/pipeline/empty_triangles.hpp>
#include <velum/spatial/mesh_octree.hpp>

#include "kernels.hpp"
#include "subject.hpp"

namespace velum_bench {
namespace {

using namespace velum;

/// The subject's clusters, their vertices on the picture, and room for what is left of one.
struct Clusters {
  MeshOctree octree;
  std::vector<PlacedVertex> placed;
  std::vector<std::uint32_t> indices, triangles;
  std::vector<std::int32_t> packed;

  explicit Clusters(const Subject& subject) : octree(subject.mesh), placed(octree.positions().size()) {
    transform_kernel(Isa::best)({&octree.positions()[0].x, placed.size(),
                                 glm::value_ptr(subject.clip_from_object), subject.viewport.width,
                                 subject.viewport.height, nullptr, nullptr, placed.data(), nullptr});
    std::size_t most = 0;
    for (std::size_t i = 0; i < octree.cluster_count(); ++i) {
      most = std::max<std::size_t>(most, octree.triangle_count(i));
    }
    indices.resize(3 * most);
    triangles.resize(most + kept_room);
    packed.resize(packed_room(3 * most));
  }

  EmptyTrianglesWork work(std::size_t i) {
    const MeshCluster cluster = octree.cluster(i);
    return {placed.data(),
            cluster.first_position,
            static_cast<std::uint32_t>(cluster.positions.size()),
            cluster.indices.data(),
            {cluster.corners[0], cluster.corners[1], cluster.corners[2]},
            cluster.windows,
            cluster.triangles.data(),
            static_cast<std::uint32_t>(cluster.triangles.size()),
            false,
            false,
            false,
            indices.data(),
            triangles.data(),
            packed.data()};
  }
};

void leave_out(benchmark::State& state, const Subject& subject, Isa isa) {
  Clusters clusters(subject);
  const LeaveOutEmpty version =
      isa == Isa::reference ? leave_out_empty_reference : empty_triangles_kernel(isa);
  for (auto _ : state) {
    Counters counters;
    for (std::size_t i = 0; i < clusters.octree.cluster_count(); ++i) {
      if (!clusters.octree.is_empty(i)) benchmark::DoNotOptimize(version(clusters.work(i), counters));
    }
    benchmark::ClobberMemory();
  }
  count_items(state, subject.mesh.triangles.size());
}

}  // namespace

void register_empty_triangles() {
  register_kernel("empty_triangles", leave_out);
}

}  // namespace velum_bench
