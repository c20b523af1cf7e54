#include "wide_bvh.hpp"

#include <limits>

#include "../intersection/watertight.hpp"

namespace velum {
namespace {

/// A ray that a kernel asks about.
struct LoneRay {
  const Ray& ray;
  const Interval& range;
  const Aabb& bounds;
  std::vector<RayHit>* all;

  bool decide(const TriangleBlock& block, std::size_t lane, WideHit& hit) const {
    return decide_exactly(PreparedRay(ray, range, bounds), block, lane, hit);
  }
};

RayHit hit_of(const WideHit& hit) {
  return {hit.t, hit.triangle, {hit.barycentric[0], hit.barycentric[1], hit.barycentric[2]}};
}

}  // namespace

Triangle triangle_in(const TriangleBlock& block, std::size_t lane) {
  const auto corner = [&](std::size_t i) {
    const auto& axes = block.corner[i];
    return glm::dvec3(glm::vec3(axes[0][lane], axes[1][lane], axes[2][lane]));
  };
  return {corner(0), corner(1), corner(2)};
}

bool decide_exactly(const PreparedRay& ray, const TriangleBlock& block, std::size_t lane, WideHit& hit) {
  const auto found = intersect_watertight(ray, triangle_in(block, lane));
  if (!found) return false;
  hit.t = found->t;
  for (int i = 0; i < 3; ++i) hit.barycentric[i] = found->barycentric[i];
  return true;
}

WideBvh::WideBvh(const TriangleSet& triangles, Isa isa)
    : Accelerator(triangles), tree_(build_wide_tree(triangles, isa)) {
  for (int axis = 0; axis < 3; ++axis) {
    float_bounds_.lower[axis] = static_cast<float>(bounds().lower[axis]);
    float_bounds_.upper[axis] = static_cast<float>(bounds().upper[axis]);
  }
  if (isa == Isa::reference) return;
  cast_ = cast_wide_kernels(isa);
  packet_kernel_ = traverse_packet_kernel(isa);
}

bool WideBvh::cast_alone(const Ray& ray, const Interval& range, Search::Aim aim, const HitFilter& filter,
                         CastCounters& counters, RayHit& hit, std::vector<RayHit>* all) const {
  const CastWide kernel =
      aim == Search::Aim::first ? cast_.first : (aim == Search::Aim::any ? cast_.any : cast_.all);
  if (kernel == nullptr || tree_.is_empty()) return false;
  LoneRay lone{ray, range, bounds(), all};
  WideQuery query;
  query.origin = &ray.origin.x;
  query.direction = &ray.direction.x;
  query.lower = range.lower;
  query.upper = range.upper;
  query.bounds = &float_bounds_;
  query.context = &lone;
  query.accepts = filter.accepts;
  query.filter_context = filter.context;
  query.decide = [](void* self, const TriangleBlock& block, std::size_t lane, WideHit& found) {
    return static_cast<const LoneRay*>(self)->decide(block, lane, found);
  };
  query.add = [](void* self, const WideHit& found) {
    static_cast<const LoneRay*>(self)->all->push_back(hit_of(found));
  };
  WideHit found;
  found.t = std::numeric_limits<double>::infinity();
  found.triangle = no_triangle;
  if (!kernel(tree_.view(), query, found, counters)) return false;
  if (found.triangle != no_triangle) hit = hit_of(found);
  return true;
}

void WideBvh::traverse(Search& search) const {
  if (!tree_.is_empty()) traverse_wide_reference(tree_, search);
}

}  // namespace velum
