#include "../visibility/zbuffer.hpp"
#include "cluster_drawer.hpp"
#include "polygon_culling.hpp"

namespace velum {

void PlainClusters::draw(const ClusterBatch& batch) {
  screen_triangles_.clear();
  for (const ClusterBatch::Entry& entry : batch.entries) {
    const ClusterBatch::PlacedMesh& placed = batch.meshes[entry.placed];
    const std::uint32_t mesh = input_.frame.scene.instances()[placed.instance].mesh;
    set_up_cluster(placed, input_.octrees.mesh(mesh).cluster(entry.cluster));
  }
  // Before anything of the batch is drawn: the pyramid's level 0 is the buffer.
  if (input_.tests_polygons && !batch.comes_first) leave_out_hidden();
  rasterize_batch();
}

void PlainClusters::set_up_cluster(const ClusterBatch::PlacedMesh& placed, const MeshCluster& cluster) {
  const RenderSettings& settings = input_.frame.settings;
  const Viewport viewport{settings.width, settings.height};
  const Scene& scene = input_.frame.scene;
  const bool mirrored = is_mirroring(scene.instances()[placed.instance].world_from_object);
  const std::uint32_t first_primitive = scene.first_primitive(placed.instance);
  transform_vertices(cluster.positions, placed.clip_from_object, vertices_);
  input_.counters.vertices += cluster.positions.size();
  const std::uint32_t first = cluster.first_position;
  for (std::size_t i = 0; i < cluster.triangles.size(); ++i) {
    const std::uint32_t* const corner = &cluster.indices[3 * i];
    const glm::uvec3 corners{corner[0] - first, corner[1] - first, corner[2] - first};
    const AssembledTriangle triangle =
        assemble(vertices_, corners, mirrored, settings.cull, clip_volume_of(settings), input_.counters);
    if (triangle.fate == TriangleFate::accepted || triangle.fate == TriangleFate::to_clip) {
      set_up(triangle, first_primitive + cluster.triangles[i], viewport, input_.counters, screen_triangles_);
    }
  }
}

void PlainClusters::leave_out_hidden() {
  const PolygonCulling culling(input_.pyramid, input_.frame.rect, input_.frame.settings.depth_format);
  std::erase_if(screen_triangles_, [&](const ScreenTriangle& triangle) {
    return culling.is_hidden(triangle, input_.counters.hierarchy);
  });
}

void PlainClusters::rasterize_batch() {
  const Rect& rect = input_.frame.rect;
  const RasterCounts counts = rasterize_zbuffer(
      screen_triangles_, {input_.buffer, rect, nullptr, input_.frame.settings.depth_format});
  input_.counters.zero_area += counts.zero_area;
  input_.counters.pixels_tested += counts.pixels_tested;
  input_.counters.fragments += counts.fragments;
  input_.counters.fragments_written += counts.fragments_written;
  for (const ScreenTriangle& triangle : screen_triangles_) {
    changed_ = united(changed_, pixels_of(triangle, rect));
  }
}

void PlainClusters::publish(bool is_last) {
  if (!is_last) input_.pyramid.update(changed_);
  changed_ = {};
  ++input_.counters.hierarchy.batches;
}

}  // namespace velum
