#include "wide_bvh.hpp"

#include <limits>

#include "../intersection/watertight.hpp"
#include "wide_ray.hpp"

namespace velum {
namespace {

/// Decides what a kernel proposes.
struct Decision {
  Search& search;
  double scale;

  float meet(const TriangleBlock& block, std::uint32_t lanes) {
    for (std::size_t lane = 0; lanes != 0; ++lane, lanes >>= 1) {
      if ((lanes & 1u) == 0) continue;
      search.decide(block.id[lane], triangle_in(block, lane));
      if (search.is_done()) return -std::numeric_limits<float>::infinity();
    }
    return rounded_up(search.limit() * scale);
  }
};

/// A ray that a kernel asks about.
struct LoneRay {
  const Ray& ray;
  const Interval& range;
  const Aabb& bounds;

  bool decide(const TriangleBlock& block, std::size_t lane, WideHit& hit) const {
    return decide_exactly(PreparedRay(ray, range, bounds), block, lane, hit);
  }
};

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
    : Accelerator(triangles),
      tree_(build_wide_tree(triangles, isa)),
      kernel_(isa == Isa::reference ? nullptr : traverse_wide_kernel(isa)),
      cast_(isa == Isa::reference ? CastWideKernels{} : cast_wide_kernels(isa)),
      packet_kernel_(isa == Isa::reference ? nullptr : traverse_packet_kernel(isa)) {
  for (int axis = 0; axis < 3; ++axis) {
    float_bounds_[axis] = static_cast<float>(bounds().lower[axis]);
    float_bounds_[3 + axis] = static_cast<float>(bounds().upper[axis]);
  }
}

bool WideBvh::cast_alone(const Ray& ray, const Interval& range, bool is_any, CastCounters& counters,
                         const HitFilter& filter, RayHit& hit) const {
  const CastWide kernel = is_any ? cast_.any : cast_.first;
  if (kernel == nullptr || tree_.is_empty()) return false;
  LoneRay context{ray, range, bounds()};
  const WideQuery query{&ray.origin.x,
                        &ray.direction.x,
                        range.lower,
                        range.upper,
                        float_bounds_,
                        &context,
                        filter.accepts,
                        filter.context,
                        [](void* self, const TriangleBlock& block, std::size_t lane, WideHit& found) {
                          return static_cast<const LoneRay*>(self)->decide(block, lane, found);
                        }};
  WideHit found{std::numeric_limits<double>::infinity(), no_triangle, {0.0, 0.0, 0.0}};
  WideCounts counts;
  if (!kernel(tree_.view(), query, found, counts)) return false;
  hit.t = found.t;
  hit.triangle = found.triangle;
  hit.barycentric = {found.barycentric[0], found.barycentric[1], found.barycentric[2]};
  ++counters.rays;
  counters.hits += hit.is_hit();
  counters.nodes += counts.nodes;
  counters.boxes += counts.boxes;
  counters.tests += counts.tests;
  return true;
}

void WideBvh::traverse(Search& search) const {
  if (tree_.is_empty()) return;
  WideRay ray;
  if (kernel_ == nullptr || !make_wide_ray(search.ray, ray)) {
    traverse_wide_reference(tree_, search);
    return;
  }
  Decision decision{search, scale_of(search.ray)};
  const WideMeeting meeting{&decision, [](void* context, const TriangleBlock& block, std::uint32_t lanes) {
                              return static_cast<Decision*>(context)->meet(block, lanes);
                            }};
  WideCounts counts;
  kernel_(tree_.view(), ray, meeting, counts);
  search.counters.nodes += counts.nodes;
  search.counters.boxes += counts.boxes;
  search.counters.tests += counts.tests;
}

}  // namespace velum
