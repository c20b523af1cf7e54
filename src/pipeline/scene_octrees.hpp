#pragma once

#include <cstdint>
#include <vector>

#include "../scene/scene.hpp"
#include "../spatial/mesh_octree.hpp"
#include "../spatial/octree.hpp"
#include "hierarchy_settings.hpp"

namespace velum {

/// The octrees of a scene: one over its instances, in world space, and one over each mesh that is used, in
/// object space, which its instances share. Built once per revision of the scene.
class SceneOctrees {
 public:
  /// Builds them, unless they stand for this revision and these options already.
  /// @return whether anything was built
  bool update(const Scene& scene, const HierarchySettings& settings);

  /// Over the instances that have triangles. Those whose box is not finite are loose.
  const Octree& instances() const { return instances_; }
  const MeshOctree& mesh(std::uint32_t mesh) const { return meshes_[mesh]; }
  /// Around the world boxes, and around all that was added up to get there: for BoxProjection.
  const Aabb& reach() const { return reach_; }

  /// Clusters of all instances are numbered one after the other. @return the number of the instance's first
  std::size_t first_cluster(std::uint32_t instance) const { return first_cluster_[instance]; }
  std::size_t cluster_count() const { return first_cluster_.empty() ? 0 : first_cluster_.back(); }

  /// Memory that they hold, bytes.
  std::size_t bytes() const;

 private:
  Aabb world_box(const Instance& instance);

  Octree instances_;
  std::vector<MeshOctree> meshes_;
  std::vector<std::size_t> first_cluster_;  // one more at the end
  Aabb reach_;
  std::uint64_t revision_ = 0;
  MeshOctreeOptions options_;
  bool is_built_ = false;
};

}  // namespace velum
