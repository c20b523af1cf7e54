// One ray at a time through a wide hierarchy, decided here.
#include "wide_cast_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/wide/wide_cast_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/highway.h>

#include "../../base/simd_dispatch.hpp"
#include "wide_box_ray-inl.hpp"
#include "wide_exact-inl.hpp"
#include "wide_lanes-inl.hpp"
#include "wide_stack-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

enum class Aim { first, any, all };

/// Whether a triangle's hit at t comes before the best one.
HWY_INLINE bool is_before(double t, std::uint32_t triangle, const WideHit& best) {
  return t < best.t || (t == best.t && triangle < best.triangle);
}

HWY_INLINE bool counts_for(const WideQuery& query, std::uint32_t triangle) {
  return query.accepts == nullptr || query.accepts(query.filter_context, triangle);
}

/// A triangle about which the routine itself has to be asked.
HWY_INLINE bool take_in_doubt(const WideQuery& query, const TriangleBlock& block, std::size_t lane,
                              WideHit& best) {
  WideHit hit;
  hit.triangle = block.id[lane];
  if (!query.decide(query.context, block, lane, hit)) return false;
  const bool is_wanted = hit.t >= query.lower && hit.t <= query.upper && is_before(hit.t, hit.triangle, best);
  if (!is_wanted || !counts_for(query, hit.triangle)) return false;
  best = hit;
  return true;
}

/// Keeps the first of the hits, or hands out all. @return whether one was kept
template <Aim aim>
HWY_INLINE bool take(const WideQuery& query, const TriangleBlock& block, const MetTriangles& triangles_met,
                     WideHit& best) {
  bool is_taken = false;
  for (std::uint32_t left = triangles_met.met; left != 0;) {
    const std::size_t lane = take_lowest(left);
    const double t = triangles_met.t[lane];
    const std::uint32_t triangle = block.id[lane];
    if ((triangles_met.in_doubt >> lane & 1u) != 0) {
      if (!take_in_doubt(query, block, lane, best)) continue;
    } else {
      if (!is_before(t, triangle, best) || !counts_for(query, triangle)) continue;
      best.t = t;
      best.triangle = triangle;
      for (std::size_t i = 0; i < 3; ++i) best.barycentric[i] = triangles_met.barycentric[i][lane];
    }
    is_taken = true;
    if (aim != Aim::all) continue;
    query.add(query.context, best);
    best.t = 1.0 / 0.0;
    best.triangle = 0xFFFFFFFFu;
  }
  return is_taken && aim != Aim::all;
}

/// One of the children that are entered: the nearest for the first hit, else as they come; the others wait.
template <Aim aim>
HWY_INLINE WideReference next_child(const Places& places, const WideNode& node, std::uint32_t mask,
                                    const float* entry, Stack& stack) {
  if (aim == Aim::first) return nearest(places, node, mask, entry, stack);
  std::size_t child = take_lowest(mask);
  while (mask != 0) {
    stack.push(Waiting(0.0f, node.child[child]));
    child = take_lowest(mask);
  }
  places.ask_for(node.child[child]);
  return node.child[child];
}

/// The next part that waits. @return false: there is none
template <Aim aim>
HWY_INLINE bool next_waiting(Stack& stack, float upper, WideReference& next) {
  if (aim == Aim::first) return take_next(stack, upper, next);
  if (stack.is_empty()) return false;
  next = stack.pop().below();
  return true;
}

template <Aim aim>
HWY_INLINE bool cast(const WideTreeView& tree, const WideQuery& query, WideHit& hit, WalkCounts& counts) {
  const BoxRay box_ray(query);
  if (!box_ray.is_usable) return false;
  ExactRay exact_ray;
  bool is_exact = false;
  const Places places(tree);
  WideReference current = tree.root;
  std::uint64_t inner = 0, leaves = 0, tests = 0;
  float upper = box_ray.upper;
  double limit = query.upper;
  Stack stack;
  for (bool is_left = true; is_left;) {
    if (!current.is_block()) {
      ++inner;
      const WideNode& node = places.node(current);
      HWY_ALIGN float entry[8];
      const std::uint32_t mask = entered(box_ray, node, upper, entry);
      if (mask != 0) {
        current = next_child<aim>(places, node, mask, entry, stack);
        continue;
      }
    } else {
      ++leaves;
      tests += current.triangles();
      const TriangleBlock& block = places.block(current);
      if (!is_exact) exact_ray.set(query);  // many rays never come here
      is_exact = true;
      const MetTriangles triangles_met(block, exact_ray, query.lower, limit);
      if (triangles_met.met != 0 && take<aim>(query, block, triangles_met, hit)) {
        if (aim == Aim::any) break;
        limit = hit.t;
        upper = not_below(limit);
      }
    }
    is_left = next_waiting<aim>(stack, upper, current);
  }
  counts.nodes += inner + leaves;
  counts.boxes += 8 * inner;
  counts.tests += tests;
  return true;
}

}  // namespace

bool cast_wide_first(const WideTreeView& tree, const WideQuery& query, WideHit& hit, WalkCounts& counts) {
  return cast<Aim::first>(tree, query, hit, counts);
}

bool cast_wide_any(const WideTreeView& tree, const WideQuery& query, WideHit& hit, WalkCounts& counts) {
  return cast<Aim::any>(tree, query, hit, counts);
}

bool cast_wide_all(const WideTreeView& tree, const WideQuery& query, WideHit& hit, WalkCounts& counts) {
  return cast<Aim::all>(tree, query, hit, counts);
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

CastWideKernels cast_wide_kernels(Isa isa) {
  static constexpr auto first = VELUM_KERNEL_VERSIONS(cast_wide_first);
  static constexpr auto any = VELUM_KERNEL_VERSIONS(cast_wide_any);
  static constexpr auto all = VELUM_KERNEL_VERSIONS(cast_wide_all);
  return {first.at(isa), any.at(isa), all.at(isa)};
}

}  // namespace velum
#endif
