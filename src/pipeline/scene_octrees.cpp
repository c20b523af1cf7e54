#include "scene_octrees.hpp"

namespace velum {
namespace {

MeshOctreeOptions options_of(const HierarchySettings& settings) {
  MeshOctreeOptions options;
  options.placement = settings.placement;
  if (settings.leaf_size != 0) options.leaf_size = settings.leaf_size;
  return options;
}

}  // namespace

bool SceneOctrees::update(const Scene& scene, const HierarchySettings& settings) {
  const MeshOctreeOptions options = options_of(settings);
  const bool has_options = options.placement == options_.placement && options.leaf_size == options_.leaf_size;
  if (is_built_ && has_options && revision_ == scene.revision()) return false;
  *this = {};
  options_ = options;
  std::vector<bool> is_used(scene.meshes().size(), false);
  for (const Instance& instance : scene.instances()) is_used[instance.mesh] = true;
  meshes_.resize(scene.meshes().size());
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    if (is_used[i]) meshes_[i] = MeshOctree(scene.meshes()[i], options);
  }
  std::vector<Aabb> boxes;
  first_cluster_.push_back(0);
  for (const Instance& instance : scene.instances()) {
    boxes.push_back(world_box(instance));
    first_cluster_.push_back(first_cluster_.back() + meshes_[instance.mesh].cluster_count());
  }
  OctreeOptions instance_options;
  instance_options.leaf_size = 1;
  instances_ = Octree(boxes, instance_options);
  revision_ = scene.revision();
  is_built_ = true;
  return true;
}

/// Around the eight corners of the mesh's box, widened by more than the roundings; empty for no triangles.
Aabb SceneOctrees::world_box(const Instance& instance) {
  const MeshOctree& mesh = meshes_[instance.mesh];
  Aabb world;
  if (mesh.nodes().empty()) return world;
  const Aabb& box = mesh.nodes().front().box;
  const glm::dmat4& m = instance.world_from_object;
  const glm::dvec3 largest = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  const glm::dvec3 terms = glm::abs(glm::dvec3(m[0])) * largest.x + glm::abs(glm::dvec3(m[1])) * largest.y +
                           glm::abs(glm::dvec3(m[2])) * largest.z + glm::abs(glm::dvec3(m[3]));
  for (const glm::dvec3& corner : box.corners()) world.include(glm::dvec3(m * glm::dvec4(corner, 1.0)));
  constexpr double unit = 0x1p-53 * 64.0;
  world.lower -= terms * unit;
  world.upper += terms * unit;
  reach_.include(terms);
  reach_.include(-terms);
  return world;
}

std::size_t SceneOctrees::bytes() const {
  std::size_t sum = instances_.bytes() + first_cluster_.capacity() * sizeof(std::size_t);
  for (const MeshOctree& mesh : meshes_) sum += mesh.bytes();
  return sum;
}

}  // namespace velum
