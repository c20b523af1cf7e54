#include "accelerator.hpp"

#include <algorithm>
#include <array>

namespace velum {
namespace {

bool is_finite(const Triangle& t) {
  const glm::dvec3 zero = (t.a - t.a) + (t.b - t.b) + (t.c - t.c);
  return zero == glm::dvec3(0.0);
}

}  // namespace

Accelerator::Accelerator(const TriangleSet& triangles) : triangles_(triangles) {
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    const Triangle triangle = triangles_[i];
    if (!is_finite(triangle)) continue;
    for (const glm::dvec3& corner : {triangle.a, triangle.b, triangle.c}) bounds_.include(corner);
  }
}

std::vector<BoxedItem> Accelerator::boxed_triangles() const {
  std::vector<BoxedItem> items;
  items.reserve(triangles_.size());
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
    if (!is_finite(triangles_[i])) continue;
    BoxedItem item;
    item.id = i;
    for (int corner = 0; corner < 3; ++corner) {
      item.box.include(triangles_.positions[triangles_.triangles[i][corner]]);
    }
    items.push_back(item);
  }
  return items;
}

RayHit Accelerator::cast(const Ray& ray, const Interval& range, Search::Aim aim, const HitFilter& filter,
                         CastCounters& counters, std::vector<RayHit>* all) const {
  RayHit hit;
  ++counters.rays;
  if (cast_alone(ray, range, aim, filter, counters, hit, all)) return hit;
  const PreparedRay prepared(ray, range, bounds_);
  if (!prepared.usable) return hit;
  ++counters.boxes;
  const Interval inside = intersect(prepared.through(bounds_.lower, bounds_.upper), range);
  if (inside.is_empty()) return hit;
  Search search(triangles_, prepared, aim, filter, counters, all);
  traverse(search);
  hit = search.hit();
  return hit;
}

RayHit Accelerator::first_hit(const Ray& ray, const Interval& range, CastCounters& counters,
                              const HitFilter& filter) const {
  const RayHit hit = cast(ray, range, Search::Aim::first, filter, counters);
  counters.hits += hit.is_hit();
  return hit;
}

void Accelerator::first_hits(std::span<const ViewRay> rays, std::span<RayHit> hits, CastCounters& counters,
                             const HitFilter& filter) const {
  constexpr std::size_t together = 8;
  for (std::size_t first = 0; first < rays.size(); first += together) {
    const std::size_t count = std::min(together, rays.size() - first);
    if (first_hits_together(rays.subspan(first, count), hits.subspan(first, count), counters, filter))
      continue;
    for (std::size_t i = first; i < first + count; ++i)
      hits[i] = first_hit(rays[i].ray, rays[i].range, counters, filter);
  }
}

bool Accelerator::cast_alone(const Ray&, const Interval&, Search::Aim, const HitFilter&, CastCounters&,
                             RayHit&, std::vector<RayHit>*) const {
  return false;
}

bool Accelerator::first_hits_together(std::span<const ViewRay>, std::span<RayHit>, CastCounters&,
                                      const HitFilter&) const {
  return false;
}

bool Accelerator::is_blocked(const Ray& ray, const Interval& range, CastCounters& counters,
                             const HitFilter& filter) const {
  const bool is_hit = cast(ray, range, Search::Aim::any, filter, counters).is_hit();
  counters.hits += is_hit;
  return is_hit;
}

void Accelerator::all_hits(const Ray& ray, const Interval& range, CastCounters& counters,
                           std::vector<RayHit>& out, const HitFilter& filter) const {
  out.clear();
  cast(ray, range, Search::Aim::all, filter, counters, &out);
  std::sort(out.begin(), out.end(),
            [](const RayHit& a, const RayHit& b) { return is_before(a.t, a.triangle, b.t, b.triangle); });
  // A structure may have handed a triangle over more than once; its hits are equal then.
  const auto same = [](const RayHit& a, const RayHit& b) { return a.triangle == b.triangle; };
  out.erase(std::unique(out.begin(), out.end(), same), out.end());
  counters.hits += out.size();
}

std::span<const AcceleratorName> accelerator_names() {
  static constexpr std::array names{
      AcceleratorName{"bvh", AcceleratorKind::bvh},
      AcceleratorName{"binary-bvh", AcceleratorKind::binary_bvh},
      AcceleratorName{"kdtree", AcceleratorKind::kd_tree},
      AcceleratorName{"grid", AcceleratorKind::grid},
      AcceleratorName{"nested-grid", AcceleratorKind::nested_grid},
      AcceleratorName{"octree", AcceleratorKind::octree},
      AcceleratorName{"bsp", AcceleratorKind::bsp},
      AcceleratorName{"brute-force", AcceleratorKind::brute_force},
  };
  return names;
}

}  // namespace velum
