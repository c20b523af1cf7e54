#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "../scene/scene.hpp"
#include "accelerator.hpp"
#include "bvh/bvh_tree.hpp"

namespace velum {

/// What a ray meets in a scene: a triangle, or nothing (t infinite).
struct SceneHit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t primitive = no_triangle;  ///< in the scene
  std::uint32_t instance = 0;
  std::uint32_t triangle = 0;  ///< among those of the instance's mesh
  glm::dvec3 barycentric{0.0};

  bool is_hit() const { return primitive != no_triangle; }
};

/// Says whether a triangle counts when a ray hits it.
struct SceneFilter {
  bool (*accepts)(const void* context, std::uint32_t instance, std::uint32_t triangle) = nullptr;
  const void* context = nullptr;
};

/// The triangles of a scene, arranged so that rays find them. Two levels: a structure of the chosen kind for
/// each mesh, in object space, and a bounding volume hierarchy over the instances' boxes. The ray is taken
/// into the object space of each instance that it meets; affine maps keep t, so hits compare.
/// Segments and points have no surface: rays miss them.
///
/// Built once; then any number of threads may ask. Meshes are shared with the scene, or viewed where the
/// scene views the caller's memory. Of hits at the same t the lower primitive id is first.
class SceneCaster {
 public:
  /// @param isa  see build_accelerator()
  SceneCaster(const Scene& scene, AcceleratorKind kind, Isa isa = Isa::best);
  /// Of structures made before. @param structures  of each mesh, all of the kind. @pre as many as meshes,
  /// each over its mesh's own arrays
  SceneCaster(const Scene& scene, AcceleratorKind kind, std::vector<std::unique_ptr<Accelerator>> structures,
              Isa isa = Isa::best);

  /// @param range  the t that are wanted; both ends included
  SceneHit first_hit(const Ray& ray, const Interval& range, CastCounters& counters,
                     const SceneFilter& filter = {}) const;
  /// The first hit of each ray; see Accelerator::first_hits(). @pre as many hits as rays
  void first_hits(std::span<const ViewRay> rays, std::span<SceneHit> hits, CastCounters& counters,
                  const SceneFilter& filter = {}) const;
  /// Whether there is any hit in the range. For p and q: Ray{p, q - p}, 0 … 1.
  bool is_blocked(const Ray& ray, const Interval& range, CastCounters& counters,
                  const SceneFilter& filter = {}) const;
  /// All hits in order of (t, primitive). @param out  overwritten
  void all_hits(const Ray& ray, const Interval& range, CastCounters& counters, std::vector<SceneHit>& out,
                const SceneFilter& filter = {}) const;

  AcceleratorKind kind() const { return kind_; }
  Isa isa() const { return isa_; }
  /// Whether it was built from this scene as it is now.
  bool is_of(const Scene& scene) const;
  /// Bytes of all structures, without vertices and indices.
  std::size_t memory() const;
  std::uint32_t mesh_count() const { return static_cast<std::uint32_t>(meshes_.size()); }
  /// The structure over the triangles of a mesh. @pre mesh < mesh_count()
  const Accelerator& structure(std::uint32_t mesh) const { return *meshes_[mesh].structure; }
  /// The hierarchy over the instances' boxes, world space.
  const BvhTree& top() const { return top_; }
  const Aabb& bounds() const { return bounds_; }
  /// @pre instance < scene.instances().size()
  std::uint32_t mesh_of(std::uint32_t instance) const { return instances_[instance].mesh; }
  std::uint32_t primitive(std::uint32_t instance, std::uint32_t triangle) const {
    return instances_[instance].first_primitive + triangle;
  }
  /// A world ray in an instance's object space.
  Ray in_object(std::uint32_t instance, const Ray& ray) const { return instances_[instance].in_object(ray); }

 private:
  struct MeshEntry {
    Array<glm::vec3> positions;
    Array<glm::uvec3> triangles;
    std::unique_ptr<Accelerator> structure;
  };
  struct Placed {
    std::uint32_t mesh = 0;
    std::uint32_t first_primitive = 0;
    glm::dmat3 object_from_world{1.0};  ///< linear part
    glm::dvec3 position{0.0};           ///< of the object's origin in the world

    Ray in_object(const Ray& ray) const {
      return {object_from_world * (ray.origin - position), object_from_world * ray.direction};
    }
  };

  template <typename Limit, typename Visit>
  void for_each_instance(const Ray& ray, const Interval& range, CastCounters& counters, const Limit& limit,
                         const Visit& visit) const;
  void first_hits_of(std::uint32_t instance, std::span<const ViewRay> rays, std::span<SceneHit> hits,
                     CastCounters& counters, const SceneFilter& filter) const;
  void add_instances(const Scene& scene);

  AcceleratorKind kind_;
  Isa isa_;
  std::uint64_t revision_;
  std::vector<MeshEntry> meshes_;
  std::vector<Placed> instances_;
  BvhTree top_;
  Aabb bounds_;  ///< of all instances, world
};

}  // namespace velum
