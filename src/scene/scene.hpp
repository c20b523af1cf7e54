#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

#include "../base/aabb.hpp"
#include "light.hpp"
#include "material.hpp"
#include "mesh.hpp"
#include "primitive_place.hpp"

namespace velum {

/// Which world axis points up. It turns the named views and the framing, never the geometry.
enum class UpAxis { y, z };

/// A mesh placed in the world.
struct Instance {
  std::uint32_t mesh = 0;
  std::uint32_t material = 0;
  glm::dmat4 world_from_object{1.0};
  std::string name;
};

/// What there is to be seen: meshes, materials, instances and lights.
///
/// Primitive ids number the primitives instance after instance, in the order in which they were added; within
/// an instance its triangles come first, then its segments, then its points. A const Scene may be rendered
/// from several threads at once: nothing derived is cached inside.
class Scene {
 public:
  UpAxis up = UpAxis::y;
  glm::vec3 ambient_light{0.15f};  ///< linear
  std::vector<DirectionalLight> directional_lights;
  std::vector<PointLight> point_lights;
  std::vector<std::string> notes;  ///< what a reader had to leave out or assume; one sentence each

  /// @return the mesh's index. @throws Error (usage) if the mesh is not valid, see validate(const Mesh&)
  std::uint32_t add_mesh(Mesh mesh);
  std::uint32_t add_material(Material material);
  /// @return the instance's index. @throws Error (usage) for an unknown mesh or material, a matrix that is
  /// singular, not finite or not affine; Error (limit) when the scene would hold more than 2³²-1 primitives
  std::uint32_t add_instance(Instance instance);
  /// Convenience: a mesh and one instance of it, with the default material (index 0).
  /// @return the instance's index. @throws as add_mesh and add_instance; the scene is then as before
  std::uint32_t add(Mesh mesh, const glm::dmat4& world_from_object = glm::dmat4(1.0),
                    std::uint32_t material = 0);

  /// Moves an instance; the primitive ids stay. @throws as add_instance
  void set_world_from_object(std::uint32_t instance, const glm::dmat4& world_from_object);
  /// Replaces a material. @throws Error (usage) for an unknown index
  void set_material(std::uint32_t index, Material material);

  const std::vector<Mesh>& meshes() const { return meshes_; }
  const std::vector<Material>& materials() const { return materials_; }
  const std::vector<Instance>& instances() const { return instances_; }

  /// The world box around all finite vertices of all instances (around their transformed vertices, not their
  /// transformed boxes).
  Aabb bounds() const;
  /// The box around a mesh's finite positions, object space. @pre mesh < meshes().size()
  const Aabb& mesh_bounds(std::uint32_t mesh) const { return mesh_bounds_[mesh]; }
  /// World points whose convex hull holds the scene: every vertex, or, beyond 2^22 vertices in all, the
  /// corners of each instance's box. For frame().
  std::vector<glm::dvec3> points() const;
  /// Changes whenever geometry or materials change: the key of derived structures. A hash over all changes so
  /// far, so it tells Scenes apart too (copies that went separate ways), without any counter they would
  /// share. Equal revisions mean equal geometry and materials; names, lights and `up` do not count. A key for
  /// this process, never for a file: it is not the same on every machine.
  std::uint64_t revision() const { return revision_; }

  std::uint32_t primitive_count() const;
  /// The id of the instance's first primitive. @pre instance < instances().size()
  std::uint32_t first_primitive(std::uint32_t instance) const;
  /// @pre primitive < primitive_count()
  PrimitivePlace place(std::uint32_t primitive) const;
  /// @pre place.instance exists, and its mesh has a primitive of this kind and index
  std::uint32_t primitive(const PrimitivePlace& place) const;

 private:
  std::vector<Mesh> meshes_;
  std::vector<Aabb> mesh_bounds_;
  std::vector<Material> materials_{Material{}};
  std::vector<Instance> instances_;
  std::vector<std::uint32_t> first_primitive_{0};  ///< instances() + 1 running sums
  std::uint64_t revision_ = 0;
};

}  // namespace velum
