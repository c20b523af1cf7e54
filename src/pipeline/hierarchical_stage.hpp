#pragma once

#include <cstdint>
#include <vector>

#include "../visibility/box_projection.hpp"
#include "cluster_drawer.hpp"
#include "scene_octrees.hpp"
#include "tile_stage.hpp"
#include "visible_clusters.hpp"

namespace velum {

/// What became of an octree node.
enum class NodeFate : std::uint8_t { drawn, outside, hidden, facing_away };

/// One node that the traversal decided about.
struct NodeRecord {
  static constexpr std::uint32_t of_scene = 0xFFFFFFFFu;
  std::uint32_t instance = of_scene;  ///< whose mesh's octree; of_scene: the octree over the instances
  std::uint32_t node = 0;
  NodeFate fate = NodeFate::drawn;  ///< drawn: its own triangles were; the others: it and all below
};

/// What the stage keeps between frames.
struct HierarchicalBuffers {
  /// An octree node that waits, with its bounds on the picture.
  struct Node {
    std::uint32_t index = 0;
    bool is_above_seen = false;  ///< something below it was seen in the frame before: there are no bounds
    BoxOnPicture bounds;
  };
  /// A cluster that is looked at once more when everything else is drawn.
  struct Postponed {
    std::uint32_t instance = 0;
    Node node;
  };
  SceneOctrees octrees;
  ZPyramid pyramid;
  TiledClusterBuffers tiles;
  ClusterBatch batch;
  std::vector<Node> scene_stack;
  std::vector<Node> mesh_stack;
  std::vector<Postponed> postponed;
  /// Per cluster of the scene what the frame before showed of it; while a frame is drawn, those that were
  /// seen are drawn already.
  std::vector<ClusterState> states;
  bool remembers = false;  ///< whether the states are about a whole frame
};

/// The hierarchical z-buffer (Greene, Kass & Miller 1993, "Hierarchical Z-Buffer Visibility"), the one loop
/// in the flow: octree nodes are visited front to back, those that the z-pyramid hides are left out with all
/// they hold, the others' triangles are drawn in batches, and each batch brings the pyramid up to date for
/// the next. What was seen in the frame before is drawn first. Clusters that seem to face away are looked at
/// last: most are hidden behind what is drawn by then.
///
/// Only triangles are drawn. Every decision errs on the safe side, so the buffer is rasterize_zbuffer's to
/// the bit; it depends on finished batches only, so the counters do not depend on threads.
/// @param buffer  cleared, of the rectangle's size
/// @param uses_tiles  the vector kernels, else the plain stages
/// @param records  where given, every decision is noted there
void draw_hierarchically(const TileStageInput& input, bool uses_tiles, HierarchicalBuffers& buffers,
                         VisibilityBuffer& buffer, Counters& counters,
                         std::vector<NodeRecord>* records = nullptr);

}  // namespace velum
