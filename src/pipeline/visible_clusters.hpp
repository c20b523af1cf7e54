#pragma once

#include <cstdint>
#include <vector>

#include "../image/visibility_buffer.hpp"
#include "scene_octrees.hpp"

namespace velum {

/// What a picture shows of a cluster.
enum class ClusterState : std::uint8_t {
  unseen,
  above_seen,  ///< nothing of its own triangles, but some below it in the octree
  seen,
};

/// Marks the clusters that a picture shows.
/// @param states  out: one per cluster of the scene
void mark_visible_clusters(const Scene& scene, const SceneOctrees& octrees, const VisibilityBuffer& buffer,
                           std::vector<ClusterState>& states);

}  // namespace velum
