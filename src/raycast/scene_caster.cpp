#include "scene_caster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>

#include "../base/contract.hpp"
#include "bvh/bvh_build.hpp"

namespace velum {
namespace {

constexpr std::size_t rays_together = 8;

/// The floats next to a double on both sides.
float below(double v) {
  const auto f = static_cast<float>(v);
  return f - std::fabs(f) * 0x1.0p-23f - std::numeric_limits<float>::min();
}
float above(double v) {
  return -below(-v);
}

/// The world box of an instance, large enough for all rounding.
Box world_box(const Aabb& object, const glm::dmat4& world_from_object) {
  Aabb world;
  double largest = 0.0;
  for (const glm::dvec3& corner : object.corners()) {
    const glm::dvec3 p(world_from_object * glm::dvec4(corner, 1.0));
    world.include(p);
    largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  const double margin = largest * 0x1.0p-40;
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lower[axis] = below(world.lower[axis] - margin);
    box.upper[axis] = above(world.upper[axis] + margin);
  }
  return box;
}

/// A filter of the scene as one of an instance's mesh.
struct InstanceFilter {
  const SceneFilter& filter;
  std::uint32_t instance;

  HitFilter of_mesh() const {
    if (filter.accepts == nullptr) return {};
    return {[](const void* context, std::uint32_t triangle) {
              const auto& self = *static_cast<const InstanceFilter*>(context);
              return self.filter.accepts(self.filter.context, self.instance, triangle);
            },
            this};
  }
};

}  // namespace

SceneCaster::SceneCaster(const Scene& scene, AcceleratorKind kind, Isa isa)
    : kind_(kind), isa_(isa), revision_(scene.revision()) {
  for (const Mesh& mesh : scene.meshes()) {
    MeshEntry entry{mesh.positions, mesh.triangles, {}};
    entry.structure = build_accelerator(kind, {entry.positions.span(), entry.triangles.span()}, isa);
    meshes_.push_back(std::move(entry));
  }
  add_instances(scene);
}

SceneCaster::SceneCaster(const Scene& scene, AcceleratorKind kind,
                         std::vector<std::unique_ptr<Accelerator>> structures, Isa isa)
    : kind_(kind), isa_(isa), revision_(scene.revision()) {
  VELUM_REQUIRE(structures.size() == scene.meshes().size(), {"structures", structures.size()},
                {"meshes", scene.meshes().size()});
  for (std::size_t i = 0; i < structures.size(); ++i) {
    const Mesh& mesh = scene.meshes()[i];
    const TriangleSet& set = structures[i]->triangles();
    VELUM_REQUIRE(
        set.positions.data() == mesh.positions.data() && set.triangles.data() == mesh.triangles.data(),
        {"mesh", i});
    meshes_.push_back({mesh.positions, mesh.triangles, std::move(structures[i])});
  }
  add_instances(scene);
}

void SceneCaster::add_instances(const Scene& scene) {
  std::vector<BoxedItem> boxes;
  for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
    const Instance& instance = scene.instances()[i];
    Placed placed;
    placed.mesh = instance.mesh;
    placed.first_primitive = scene.first_primitive(i);
    placed.object_from_world = glm::inverse(glm::dmat3(instance.world_from_object));
    placed.position = glm::dvec3(instance.world_from_object[3]);
    instances_.push_back(placed);
    const Aabb& object = structure(instance.mesh).bounds();
    if (object.is_empty()) continue;
    boxes.push_back({world_box(object, instance.world_from_object), i});
    bounds_.include(glm::dvec3(boxes.back().box.lower));
    bounds_.include(glm::dvec3(boxes.back().box.upper));
  }
  top_ = build_bvh(std::move(boxes), {});
}

bool SceneCaster::is_of(const Scene& scene) const {
  if (scene.revision() != revision_ || scene.meshes().size() != meshes_.size()) return false;
  return std::equal(meshes_.begin(), meshes_.end(), scene.meshes().begin(),
                    [](const MeshEntry& entry, const Mesh& mesh) {
                      return entry.positions.data() == mesh.positions.data() &&
                             entry.triangles.data() == mesh.triangles.data();
                    });
}

std::size_t SceneCaster::memory() const {
  std::size_t bytes = top_.memory() + instances_.size() * sizeof(Placed);
  for (const MeshEntry& entry : meshes_) bytes += entry.structure->memory();
  return bytes;
}

/// Visits the instances whose boxes the ray meets. @param visit  (instance) → whether to go on
template <typename Limit, typename Visit>
void SceneCaster::for_each_instance(const Ray& ray, const Interval& range, CastCounters& counters,
                                    const Limit& limit, const Visit& visit) const {
  ++counters.rays;
  const PreparedRay prepared(ray, range, bounds_);
  if (!prepared.usable) return;
  top_.traverse(prepared, counters, limit, [&](std::span<const std::uint32_t> ids) {
    for (const std::uint32_t id : ids) {
      if (!visit(id)) return false;
    }
    return true;
  });
}

SceneHit SceneCaster::first_hit(const Ray& ray, const Interval& range, CastCounters& counters,
                                const SceneFilter& filter) const {
  SceneHit best;
  const auto limit = [&] { return std::min(best.t, range.upper); };
  for_each_instance(ray, range, counters, limit, [&](std::uint32_t id) {
    const Placed& placed = instances_[id];
    const InstanceFilter of_instance{filter, id};
    CastCounters inner;
    const RayHit hit =
        structure(placed.mesh)
            .first_hit(placed.in_object(ray), {range.lower, limit()}, inner, of_instance.of_mesh());
    inner.rays = inner.hits = 0;
    counters += inner;
    const std::uint32_t primitive = placed.first_primitive + hit.triangle;
    if (hit.is_hit() && is_before(hit.t, primitive, best.t, best.primitive)) {
      best = {hit.t, primitive, id, hit.triangle, hit.barycentric};
    }
    return true;
  });
  counters.hits += best.is_hit();
  return best;
}

/// Up to eight rays into one instance, for what is nearer than their hits so far.
void SceneCaster::first_hits_of(std::uint32_t instance, std::span<const ViewRay> rays,
                                std::span<SceneHit> hits, CastCounters& counters,
                                const SceneFilter& filter) const {
  const Placed& placed = instances_[instance];
  const InstanceFilter of_instance{filter, instance};
  std::array<ViewRay, rays_together> inside;
  std::array<RayHit, rays_together> found;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    inside[i].ray = placed.in_object(rays[i].ray);
    inside[i].range = {rays[i].range.lower, std::min(hits[i].t, rays[i].range.upper)};
  }
  CastCounters inner;
  structure(placed.mesh)
      .first_hits({inside.data(), rays.size()}, {found.data(), rays.size()}, inner, of_instance.of_mesh());
  inner.rays = inner.hits = 0;
  counters += inner;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RayHit& hit = found[i];
    const std::uint32_t primitive = placed.first_primitive + hit.triangle;
    if (hit.is_hit() && is_before(hit.t, primitive, hits[i].t, hits[i].primitive))
      hits[i] = {hit.t, primitive, instance, hit.triangle, hit.barycentric};
  }
}

void SceneCaster::first_hits(std::span<const ViewRay> rays, std::span<SceneHit> hits, CastCounters& counters,
                             const SceneFilter& filter) const {
  // With many instances it pays to ask for each ray which of them it meets.
  constexpr std::size_t few_instances = 4;
  if (instances_.size() > few_instances) {
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = first_hit(rays[i].ray, rays[i].range, counters, filter);
    return;
  }
  for (std::size_t first = 0; first < rays.size(); first += rays_together) {
    const std::size_t count = std::min(rays_together, rays.size() - first);
    const std::span<SceneHit> of_these = hits.subspan(first, count);
    std::fill(of_these.begin(), of_these.end(), SceneHit{});
    for (std::uint32_t instance = 0; instance < instances_.size(); ++instance)
      first_hits_of(instance, rays.subspan(first, count), of_these, counters, filter);
    counters.rays += count;
    for (const SceneHit& hit : of_these) counters.hits += hit.is_hit();
  }
}

bool SceneCaster::is_blocked(const Ray& ray, const Interval& range, CastCounters& counters,
                             const SceneFilter& filter) const {
  bool blocked = false;
  const auto limit = [&] { return range.upper; };
  for_each_instance(ray, range, counters, limit, [&](std::uint32_t id) {
    const Placed& placed = instances_[id];
    const InstanceFilter of_instance{filter, id};
    CastCounters inner;
    blocked = structure(placed.mesh).is_blocked(placed.in_object(ray), range, inner, of_instance.of_mesh());
    inner.rays = inner.hits = 0;
    counters += inner;
    return !blocked;
  });
  counters.hits += blocked;
  return blocked;
}

void SceneCaster::all_hits(const Ray& ray, const Interval& range, CastCounters& counters,
                           std::vector<SceneHit>& out, const SceneFilter& filter) const {
  out.clear();
  std::vector<RayHit> hits;
  const auto limit = [&] { return range.upper; };
  for_each_instance(ray, range, counters, limit, [&](std::uint32_t id) {
    const Placed& placed = instances_[id];
    const InstanceFilter of_instance{filter, id};
    CastCounters inner;
    structure(placed.mesh).all_hits(placed.in_object(ray), range, inner, hits, of_instance.of_mesh());
    inner.rays = inner.hits = 0;
    counters += inner;
    for (const RayHit& hit : hits) {
      out.push_back({hit.t, placed.first_primitive + hit.triangle, id, hit.triangle, hit.barycentric});
    }
    return true;
  });
  std::sort(out.begin(), out.end(), [](const SceneHit& a, const SceneHit& b) {
    return is_before(a.t, a.primitive, b.t, b.primitive);
  });
  counters.hits += out.size();
}

}  // namespace velum
