#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <utility>

#include "../base/contract.hpp"
#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "revision.hpp"

namespace velum {
namespace {

constexpr std::uint64_t k_most_primitives = std::numeric_limits<std::uint32_t>::max();

/// What a revision hashes first, so that different kinds of change never look alike.
enum class Change : std::uint64_t { mesh = 1, material, instance, placement, new_material };

RevisionHash change(std::uint64_t revision, Change kind) {
  RevisionHash hash(revision);
  return hash.word(static_cast<std::uint64_t>(kind));
}

template <typename T>
void hash_array(RevisionHash& hash, const Array<T>& array) {
  hash.values(array.data(), array.size());
}

void hash_material(RevisionHash& hash, const Material& m) {
  hash.text(m.name).text(m.base_colour_texture);
  hash.value(m.base_colour).value(m.ambient).value(m.diffuse).value(m.specular).value(m.absorption);
  hash.value(m.shininess).value(m.alpha).value(m.mirror_share).value(m.transmission_share);
  hash.value(m.refractive_index);
  hash.word(m.texture ? m.texture->content_hash() : 0);
  hash.value(m.texture_mapping.wrap).value(m.texture_mapping.scale).value(m.texture_mapping.offset);
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

[[noreturn]] void refuse(const std::string& problem, const std::string& where, const std::string& remedy) {
  throw Error(ErrorKind::usage, problem, where, remedy);
}

void require_known(std::uint32_t index, std::size_t count, const std::string& kind,
                   const std::string& where) {
  if (index < count) return;
  refuse("unknown " + kind + " " + std::to_string(index) + ": the scene has " + std::to_string(count), where,
         "add the " + kind + " first; indices count from 0");
}

/// Whether the columns are linearly dependent within rounding: the volume of the box they span after each is
/// scaled to length one, so that a uniformly tiny or huge scale is not mistaken for a singular one.
bool is_singular(const glm::dmat4& matrix) {
  glm::dmat3 columns;
  for (glm::length_t i = 0; i < 3; ++i) {
    const glm::dvec3 column(matrix[i]);
    const double largest = std::max({std::abs(column.x), std::abs(column.y), std::abs(column.z)});
    if (largest == 0.0) return true;
    const glm::dvec3 scaled = column / largest;
    columns[i] = scaled / std::sqrt(glm::dot(scaled, scaled));
  }
  constexpr double rounding = 1e-14;  // some tens of units in the last place of the entries
  return std::abs(glm::determinant(columns)) < rounding;
}

void require_placeable(const glm::dmat4& world_from_object, const std::string& where) {
  for (glm::length_t column = 0; column < 4; ++column) {
    for (glm::length_t row = 0; row < 4; ++row) {
      if (std::isfinite(world_from_object[column][row])) continue;
      refuse("the model matrix is not finite in row " + std::to_string(row) + ", column " +
                 std::to_string(column),
             where, "give finite numbers");
    }
    if (world_from_object[column][3] != (column == 3 ? 1.0 : 0.0)) {
      refuse("the model matrix is not affine", where,
             "its last row must be 0 0 0 1; a perspective belongs in the camera");
    }
  }
  if (is_singular(world_from_object)) {
    refuse("the model matrix is singular: it flattens the mesh", where, "use scales other than zero");
  }
}

std::string place_of(const Instance& instance) {
  return "instance '" + instance.name + "'";
}

void require_room(std::uint64_t primitives, std::size_t more, const std::string& where) {
  if (more <= k_most_primitives - primitives) return;
  throw Error(ErrorKind::limit,
              "the scene would hold " + std::to_string(primitives) + " + " + std::to_string(more) +
                  " primitives, more than the " + std::to_string(k_most_primitives) +
                  " that 32-bit ids can name",
              where, "use fewer instances or coarser meshes");
}

/// Each world axis depends on one object axis only: then the box of the images is the image of the box.
bool keeps_boxes(const glm::dmat4& matrix) {
  for (glm::length_t row = 0; row < 3; ++row) {
    const int used = (matrix[0][row] != 0.0) + (matrix[1][row] != 0.0) + (matrix[2][row] != 0.0);
    if (used != 1) return false;
  }
  return true;
}

glm::dvec3 transform(const glm::dmat4& matrix, const glm::dvec3& p) {
  return glm::dvec3(matrix[0]) * p.x + glm::dvec3(matrix[1]) * p.y + glm::dvec3(matrix[2]) * p.z +
         glm::dvec3(matrix[3]);
}

Aabb world_bounds(const Mesh& mesh, const Aabb& object_bounds, const glm::dmat4& world_from_object) {
  Aabb box;
  if (object_bounds.is_empty()) return box;
  const auto include = [&](const glm::dvec3& position) {
    const glm::dvec3 world = transform(world_from_object, position);
    if (is_finite(world)) box.include(world);
  };
  if (keeps_boxes(world_from_object)) {
    include(object_bounds.lower);
    include(object_bounds.upper);
  } else {
    for (const glm::vec3& position : mesh.positions) include(glm::dvec3(position));
  }
  return box;
}

}  // namespace

std::uint32_t Scene::add_mesh(Mesh mesh) {
  validate(mesh);
  RevisionHash hash = change(revision_, Change::mesh);
  hash_array(hash, mesh.positions);
  hash_array(hash, mesh.normals);
  hash_array(hash, mesh.texture_coordinates);
  hash_array(hash, mesh.colours);
  hash_array(hash, mesh.triangles);
  hash_array(hash, mesh.segments);
  hash_array(hash, mesh.points);
  mesh_bounds_.push_back(velum::bounds(mesh));
  meshes_.push_back(std::move(mesh));
  revision_ = hash.result();
  return static_cast<std::uint32_t>(meshes_.size() - 1);
}

std::uint32_t Scene::add_material(Material material) {
  RevisionHash hash = change(revision_, Change::material);
  hash_material(hash, material);
  materials_.push_back(std::move(material));
  revision_ = hash.result();
  return static_cast<std::uint32_t>(materials_.size() - 1);
}

std::uint32_t Scene::add_instance(Instance instance) {
  const FloatingPointScope floating_point;
  const std::string where = place_of(instance);
  require_known(instance.mesh, meshes_.size(), "mesh", where);
  require_known(instance.material, materials_.size(), "material", where);
  require_placeable(instance.world_from_object, where);
  const std::size_t primitives = meshes_[instance.mesh].primitive_count();
  require_room(first_primitive_.back(), primitives, where);
  RevisionHash hash = change(revision_, Change::instance);
  hash.word(instance.mesh).word(instance.material).value(instance.world_from_object);
  first_primitive_.push_back(first_primitive_.back() + static_cast<std::uint32_t>(primitives));
  instances_.push_back(std::move(instance));
  revision_ = hash.result();
  return static_cast<std::uint32_t>(instances_.size() - 1);
}

std::uint32_t Scene::add(Mesh mesh, const glm::dmat4& world_from_object, std::uint32_t material) {
  Instance instance{0, material, world_from_object, mesh.name};
  // What add_instance would refuse is refused before the mesh is added: a failed call leaves the scene alone.
  require_known(material, materials_.size(), "material", place_of(instance));
  require_placeable(world_from_object, place_of(instance));
  require_room(first_primitive_.back(), mesh.primitive_count(), place_of(instance));
  instance.mesh = add_mesh(std::move(mesh));
  return add_instance(std::move(instance));
}

void Scene::set_world_from_object(std::uint32_t instance, const glm::dmat4& world_from_object) {
  require_known(instance, instances_.size(), "instance", "set_world_from_object");
  require_placeable(world_from_object, place_of(instances_[instance]));
  instances_[instance].world_from_object = world_from_object;
  revision_ = change(revision_, Change::placement).word(instance).value(world_from_object).result();
}

void Scene::set_material(std::uint32_t index, Material material) {
  require_known(index, materials_.size(), "material", "set_material");
  RevisionHash hash = change(revision_, Change::new_material);
  hash.word(index);
  hash_material(hash, material);
  materials_[index] = std::move(material);
  revision_ = hash.result();
}

std::vector<glm::dvec3> Scene::points() const {
  const FloatingPointScope floating_point;
  constexpr std::uint64_t most_vertices = 1u << 22;
  std::uint64_t vertices = 0;
  for (const Instance& instance : instances_) vertices += meshes_[instance.mesh].positions.size();
  std::vector<glm::dvec3> result;
  for (const Instance& instance : instances_) {
    const auto add_point = [&](const glm::dvec3& p) {
      result.emplace_back(instance.world_from_object * glm::dvec4(p, 1.0));
    };
    const Aabb& box = mesh_bounds_[instance.mesh];
    if (vertices <= most_vertices) {
      for (const glm::vec3& p : meshes_[instance.mesh].positions) add_point(glm::dvec3(p));
    } else if (!box.is_empty()) {
      for (const glm::dvec3& corner : box.corners()) add_point(corner);
    }
  }
  return result;
}

Aabb Scene::bounds() const {
  const FloatingPointScope floating_point;
  Aabb box;
  for (const Instance& instance : instances_) {
    box.include(
        world_bounds(meshes_[instance.mesh], mesh_bounds_[instance.mesh], instance.world_from_object));
  }
  return box;
}

std::uint32_t Scene::primitive_count() const {
  return first_primitive_.back();
}

std::uint32_t Scene::first_primitive(std::uint32_t instance) const {
  VELUM_REQUIRE(instance < instances_.size(), {"instance", instance}, {"instances", instances_.size()});
  return first_primitive_[instance];
}

PrimitivePlace Scene::place(std::uint32_t primitive) const {
  VELUM_REQUIRE(primitive < primitive_count(), {"primitive", primitive}, {"count", primitive_count()});
  // The last instance that begins at or before it: empty instances begin where the next one does and lose.
  const auto next = std::upper_bound(first_primitive_.begin(), first_primitive_.end(), primitive);
  const auto instance = static_cast<std::uint32_t>(next - first_primitive_.begin() - 1);
  const Mesh& mesh = meshes_[instances_[instance].mesh];
  std::uint32_t index = primitive - first_primitive_[instance];
  if (index < mesh.triangles.size()) return {instance, index, PrimitiveKind::triangle};
  index -= static_cast<std::uint32_t>(mesh.triangles.size());
  if (index < mesh.segments.size()) return {instance, index, PrimitiveKind::segment};
  return {instance, index - static_cast<std::uint32_t>(mesh.segments.size()), PrimitiveKind::point};
}

std::uint32_t Scene::primitive(const PrimitivePlace& place) const {
  const std::uint32_t first = first_primitive(place.instance);
  const Mesh& mesh = meshes_[instances_[place.instance].mesh];
  const bool is_triangle = place.kind == PrimitiveKind::triangle;
  const bool is_segment = place.kind == PrimitiveKind::segment;
  const std::size_t count = is_triangle  ? mesh.triangles.size()
                            : is_segment ? mesh.segments.size()
                                         : mesh.points.size();
  VELUM_REQUIRE(place.index < count, {"instance", place.instance}, {"index", place.index}, {"count", count});
  const std::size_t before = is_triangle  ? 0
                             : is_segment ? mesh.triangles.size()
                                          : mesh.triangles.size() + mesh.segments.size();
  return first + static_cast<std::uint32_t>(before) + place.index;
}

}  // namespace velum
