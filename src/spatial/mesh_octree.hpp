#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "../scene/mesh.hpp"
#include "corner_window.hpp"
#include "normal_cone.hpp"
#include "octree.hpp"
#include "oriented_box.hpp"

namespace velum {

/// The triangles that one octree node holds itself, or those of neighbouring nodes, ready to be drawn on
/// their own: a short list of vertices, and indices. Drawing few nodes so transforms few vertices. A node's
/// triangles stand in the order in which a plane sweeps over them.
struct MeshCluster {
  std::span<const glm::vec3> positions;      ///< object space; of each node, each of the mesh's vertices once
  std::uint32_t first_position = 0;          ///< where they stand among all of MeshOctree::positions()
  std::span<const std::uint32_t> indices;    ///< three per triangle, into MeshOctree::positions()
  std::span<const std::uint32_t> triangles;  ///< which of the mesh's triangles they are
  /// The first, second, third corners' indices less first_position, modulo 65536; so many more can be read
  /// behind the last as corners_behind says. Of one node: of neighbouring nodes each counts its own.
  const std::uint16_t* corners[3] = {nullptr, nullptr, nullptr};
  const std::uint16_t* windows = nullptr;  ///< of the corners, see corner_window.hpp; of one node only
};
inline constexpr std::size_t corners_behind = 16;

struct MeshOctreeOptions {
  OctreePlacement placement = OctreePlacement::pushed_down;
  std::uint32_t leaf_size = 384;  ///< triangles
};

/// An octree over the triangles of a mesh. Its segments and points are not in it.
class MeshOctree {
 public:
  MeshOctree() = default;
  explicit MeshOctree(const Mesh& mesh, const MeshOctreeOptions& options = {});

  const std::vector<OctreeNode>& nodes() const { return octree_.nodes(); }
  int depth() const { return octree_.depth(); }

  /// One cluster per node, with the same number, empty for those without triangles of their own; and one more
  /// with the triangles that have a vertex which is not finite: they have no place in space.
  std::size_t cluster_count() const { return spans_.size(); }
  MeshCluster cluster(std::size_t i) const { return clusters(i, i + 1); }
  /// Clusters first … end-1 as one: what they hold stands side by side. @pre first < end
  MeshCluster clusters(std::size_t first, std::size_t end) const;
  /// Of all clusters, one after the other.
  std::span<const glm::vec3> positions() const { return positions_; }
  /// Whether there is nothing between two clusters. @pre first < second
  bool are_neighbours(std::size_t first, std::size_t second) const {
    return spans_[first].first_triangle + spans_[first].triangle_count == spans_[second].first_triangle;
  }
  std::uint32_t triangle_count(std::size_t cluster) const { return spans_[cluster].triangle_count; }
  bool is_empty(std::size_t cluster) const { return spans_[cluster].triangle_count == 0; }
  const NormalCone& cone(std::size_t cluster) const { return cones_[cluster]; }
  /// Around the cluster's positions, along its surface. @pre not is_empty(cluster), and not the last
  const OrientedBox& tight_box(std::size_t cluster) const { return tight_boxes_[cluster]; }
  /// Triangles in a node's whole subtree.
  std::uint32_t triangles_below(std::size_t node) const { return nodes()[node].end - nodes()[node].first; }
  /// The node above; no_parent for the root, and for the last cluster.
  static constexpr std::uint32_t no_parent = 0xFFFFFFFFu;
  std::uint32_t parent(std::size_t cluster) const { return parents_[cluster]; }
  /// The cluster of each of the mesh's triangles.
  const std::vector<std::uint32_t>& cluster_of_triangle() const { return cluster_of_triangle_; }

  /// Memory that it holds, bytes.
  std::size_t bytes() const;

 private:
  struct Span {
    std::uint32_t first_position, position_count, first_triangle, triangle_count, first_window;
  };
  class Writer;

  Octree octree_;
  std::vector<Span> spans_;
  std::vector<NormalCone> cones_;
  std::vector<OrientedBox> tight_boxes_;
  std::vector<glm::vec3> positions_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::uint32_t> cluster_of_triangle_;
  std::vector<std::uint32_t> parents_;
  std::vector<std::uint16_t> corners_[3];
  std::vector<std::uint16_t> windows_;
};

}  // namespace velum
