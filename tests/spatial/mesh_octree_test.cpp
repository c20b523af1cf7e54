#include "spatial/mesh_octree.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <vector>
#include <velum/velum.hpp>

using namespace velum;

namespace {

/// Every triangle of the mesh is in one cluster, with its own three positions.
void check(const Mesh& mesh, const MeshOctree& octree) {
  std::vector<int> seen(mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < octree.cluster_count(); ++i) {
    const MeshCluster cluster = octree.cluster(i);
    CHECK(octree.is_empty(i) == cluster.triangles.empty());
    REQUIRE(cluster.indices.size() == 3 * cluster.triangles.size());
    for (std::size_t k = 0; k < cluster.triangles.size(); ++k) {
      const std::uint32_t number = cluster.triangles[k];
      ++seen[number];
      CHECK(octree.cluster_of_triangle()[number] == i);
      const glm::uvec3& triangle = mesh.triangles[number];
      const std::uint32_t vertices[3] = {triangle.x, triangle.y, triangle.z};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::vec3 mine = octree.positions()[cluster.indices[3 * k + corner]];
        const glm::vec3 theirs = mesh.positions[vertices[corner]];
        for (int axis = 0; axis < 3; ++axis) CHECK(!(mine[axis] < theirs[axis] || mine[axis] > theirs[axis]));
      }
    }
  }
  for (const int times : seen) CHECK(times == 1);
}

}  // namespace

TEST_CASE("a mesh's clusters hold its triangles, each once") {
  const Mesh mesh = shapes::torus(1.0f, 0.4f, 60, 40);
  for (const OctreePlacement placement : {OctreePlacement::pushed_down, OctreePlacement::kept}) {
    MeshOctreeOptions options;
    options.placement = placement;
    options.leaf_size = 40;
    const MeshOctree octree(mesh, options);
    check(mesh, octree);
    CHECK(octree.nodes().size() > 50);
    CHECK(octree.triangles_below(0) == mesh.triangles.size());
    CHECK(octree.bytes() > mesh.triangles.size() * 16);
  }
}

TEST_CASE("neighbouring triangles of a cluster mostly have neighbouring vertices") {
  const Mesh mesh = shapes::torus(1.0f, 0.4f, 120, 80);
  const MeshOctree octree(mesh);
  std::size_t all = 0, near = 0;
  for (std::size_t i = 0; i < octree.cluster_count(); ++i) {
    const MeshCluster cluster = octree.cluster(i);
    for (std::size_t k = 0; k < cluster.triangles.size(); ++k) {
      const std::uint16_t window = cluster.windows[k / window_triangles];
      ++all;
      if (window == no_window) continue;
      ++near;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        CHECK(cluster.corners[corner][k] + cluster.first_position == cluster.indices[3 * k + corner]);
        CHECK((cluster.corners[corner][k] >= window && cluster.corners[corner][k] < window + window_corners));
      }
    }
  }
  CHECK(near > all * 8 / 10);
}

TEST_CASE("triangles with a vertex that is not finite are in the last cluster") {
  Mesh mesh = shapes::cube();
  std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
  positions.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0.0f, 0.0f);
  positions.emplace_back(0.0f, std::numeric_limits<float>::infinity(), 0.0f);
  std::vector<glm::uvec3> triangles(mesh.triangles.begin(), mesh.triangles.end());
  const auto count = static_cast<std::uint32_t>(positions.size());
  triangles.emplace_back(0, 1, count - 2);
  triangles.emplace_back(count - 1, 1, 2);
  mesh.positions = std::move(positions);
  mesh.triangles = std::move(triangles);
  const MeshOctree octree(mesh);
  check(mesh, octree);
  CHECK(octree.cluster(octree.cluster_count() - 1).triangles.size() == 2);
}

TEST_CASE("a mesh without triangles has an octree without nodes") {
  const MeshOctree octree{Mesh{}};
  CHECK(octree.nodes().empty());
  CHECK(octree.cluster_count() == 1);
  CHECK(octree.is_empty(0));
}
