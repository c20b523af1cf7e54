#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "../visibility/z_pyramid.hpp"
#include "empty_triangles.hpp"
#include "scene_octrees.hpp"
#include "tile_stage.hpp"

namespace velum {

/// Clusters that are to be drawn, of one mesh placed in the scene after the other, each one's in their order.
struct ClusterBatch {
  struct PlacedMesh {
    std::uint32_t instance = 0;
    glm::dmat4 clip_from_object{1.0};
  };
  struct Entry {
    std::uint32_t placed = 0;  ///< which of `meshes`
    std::uint32_t cluster = 0;
  };
  std::vector<PlacedMesh> meshes;
  std::vector<Entry> entries;
  std::uint64_t triangles = 0;  ///< of all entries together
  bool comes_first = false;     ///< nothing stands in front of it yet: its polygons are not tested

  void clear() {
    meshes.clear();
    entries.clear();
    triangles = 0;
    comes_first = false;
  }
};

/// What drawing clusters needs to know of the frame.
struct ClusterInput {
  const TileStageInput& frame;
  const SceneOctrees& octrees;
  ZPyramid& pyramid;
  VisibilityBuffer& buffer;  ///< what the pyramid stands over
  Counters& counters;
  bool tests_polygons;  ///< against the pyramid, one by one
};

/// Takes clusters through transform, set-up and raster.
class ClusterDrawer {
 public:
  virtual ~ClusterDrawer() = default;
  /// The pyramid may lag behind until publish().
  virtual void draw(const ClusterBatch& batch) = 0;
  /// Brings the visibility buffer up to date, and the pyramid, unless nobody asks it any more.
  virtual void publish(bool is_last) = 0;
};

/// The plain stages, one cluster after the other, and rasterize_zbuffer: the oracle of the other.
class PlainClusters : public ClusterDrawer {
 public:
  explicit PlainClusters(const ClusterInput& input) : input_(input) {}
  void draw(const ClusterBatch& batch) override;
  void publish(bool is_last) override;

 private:
  void set_up_cluster(const ClusterBatch::PlacedMesh& placed, const MeshCluster& cluster);
  void leave_out_hidden();
  void rasterize_batch();

  const ClusterInput input_;
  ClipVertices vertices_;
  std::vector<ScreenTriangle> screen_triangles_;
  Rect changed_{};  // pixels of the buffer
};

/// What TiledClusters keeps between frames.
struct TiledClusterBuffers {
  /// A run of clusters that one worker sets up and sorts into tiles.
  struct Group {
    std::uint32_t first = 0;  ///< entries of the batch
    std::uint32_t last = 0;
    std::size_t triangles = 0;
    ScreenPrimitives primitives;
    TileBins bins;
    Counters counters;
  };
  /// Memory of a worker.
  struct Worker {
    glm::dmat4 clip_from_object;         ///< of the instance that is set up
    std::vector<PlacedVertex> placed;    ///< its vertices, as far as they are needed
    KeptArray<std::int32_t> packed;      ///< vertices of a cluster, see EmptyTrianglesWork
    KeptArray<std::uint32_t> indices;    ///< of a group's triangles that may cover a pixel centre
    KeptArray<std::uint32_t> triangles;  ///< and which of the mesh's they are
    std::uint32_t kept = 0;              ///< how many
    BatchScratch scratch;
    TileOrder order;
    TileCounts counts;
  };
  enum class TileState : std::uint8_t { untouched, published, changed };

  std::vector<Group> groups;  ///< the first `used` are the batch's
  std::size_t used = 0;
  std::vector<Worker> workers;
  std::vector<TileBuffer> tiles;  ///< all of the picture's: they stay where they are until the frame is done
  std::vector<TileState> states;
};

/// The vector kernels, on all threads: groups of clusters are set up and sorted into tiles, then each tile
/// draws its triangles. Triangles of a pixel or two are not tested against the pyramid: drawing them is as
/// cheap.
class TiledClusters : public ClusterDrawer {
 public:
  TiledClusters(const ClusterInput& input, TiledClusterBuffers& buffers);
  void draw(const ClusterBatch& batch) override;
  void publish(bool is_last) override;

 private:
  using Group = TiledClusterBuffers::Group;
  using Worker = TiledClusterBuffers::Worker;
  void make_groups(const ClusterBatch& batch);
  void set_up_group(const ClusterBatch& batch, Group& group, Worker& worker) const;
  void set_up_instance(const ClusterBatch& batch, std::uint32_t first, std::uint32_t end, Group& group,
                       Worker& worker) const;
  void place_vertices(const ClusterBatch::PlacedMesh& placed, const MeshOctree& octree,
                      const MeshCluster& cluster, Group& group, Worker& worker) const;
  void leave_out_empty(const MeshCluster& cluster, bool is_mirrored, Group& group, Worker& worker) const;
  void leave_out_hidden(ScreenPrimitives& primitives, HierarchyCounters& counters) const;
  void draw_tile(std::size_t tile, Worker& worker) const;
  void publish_tile(std::size_t tile, int last_level) const;

  const ClusterInput input_;
  TiledClusterBuffers& buffers_;
  const TileGrid grid_;
  const TransformVertices transform_;
  const LeaveOutEmpty leave_out_empty_;
  const SetUpTriangles set_up_;
  const SmallSource::SetUp set_up_small_;
  const TileRaster raster_;
};

}  // namespace velum
