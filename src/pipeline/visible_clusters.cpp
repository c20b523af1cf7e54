#include "visible_clusters.hpp"

namespace velum {
namespace {

/// How many ids from the first on are this one: eight at a time, so it may be fewer.
int same_as(std::uint32_t id, const std::uint32_t* ids, int count) {
  constexpr int lanes = 8;
  int same = 0;
  for (; same + lanes <= count; same += lanes) {
    std::uint32_t differing = 0;
    for (int i = 0; i < lanes; ++i) differing |= ids[same + i] ^ id;
    if (differing != 0) break;
  }
  return same;
}

/// Finds clusters by their triangles' ids; neighbours often share their instance.
class ClusterMarks {
 public:
  ClusterMarks(const Scene& scene, const SceneOctrees& octrees, std::vector<ClusterState>& states)
      : scene_(scene), octrees_(octrees), states_(states) {}

  void mark(std::uint32_t primitive) {
    if (primitive < begin_ || primitive >= end_) find_instance(primitive);
    if (primitive >= end_) return;  // a segment or point
    const MeshOctree& octree = octrees_.mesh(scene_.instances()[instance_].mesh);
    ClusterState* const states = &states_[octrees_.first_cluster(instance_)];
    std::uint32_t cluster = octree.cluster_of_triangle()[primitive - begin_];
    if (states[cluster] == ClusterState::seen) return;
    states[cluster] = ClusterState::seen;
    for (cluster = octree.parent(cluster); cluster != MeshOctree::no_parent;
         cluster = octree.parent(cluster)) {
      if (states[cluster] != ClusterState::unseen) return;
      states[cluster] = ClusterState::above_seen;
    }
  }

 private:
  void find_instance(std::uint32_t primitive) {
    instance_ = scene_.place(primitive).instance;
    begin_ = scene_.first_primitive(instance_);
    const Mesh& mesh = scene_.meshes()[scene_.instances()[instance_].mesh];
    end_ = begin_ + static_cast<std::uint32_t>(mesh.triangles.size());
  }

  const Scene& scene_;
  const SceneOctrees& octrees_;
  std::vector<ClusterState>& states_;
  std::uint32_t instance_ = 0, begin_ = 0, end_ = 0;  // whose triangles' ids are begin_ … end_-1
};

}  // namespace

void mark_visible_clusters(const Scene& scene, const SceneOctrees& octrees, const VisibilityBuffer& buffer,
                           std::vector<ClusterState>& states) {
  states.assign(octrees.cluster_count(), ClusterState::unseen);
  ClusterMarks marks(scene, octrees, states);
  std::uint32_t last = no_primitive;
  for (int y = 0; y < buffer.height(); ++y) {
    const std::uint32_t* const row = buffer.primitive.row(y);
    for (int x = 0; x < buffer.width(); ++x) {
      if (row[x] == last) {
        x += same_as(last, row + x + 1, buffer.width() - x - 1);
        continue;
      }
      last = row[x];
      if (last != no_primitive) marks.mark(last);
    }
  }
}

}  // namespace velum
