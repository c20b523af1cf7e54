// One ray at a time through a wide hierarchy, decided here.
#include "wide_cast_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/wide/wide_cast_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/highway.h>

#include "../../base/simd_dispatch.hpp"
#include "wide_exact-inl.hpp"
#include "wide_float_ray-inl.hpp"
#include "wide_lanes-inl.hpp"
#include "wide_stack-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// The ray's numbers for boxes; t is not scaled.
/// @return false if they are too large or too small
///
/// An interval that is computed from them holds the interval that PreparedRay::through() gives for the same
/// box in double: the margin, 2^-20 of the reach and 2^-22 of the origin, is more than the rounding of the
/// origin (2^-24 of it), of the reach, the difference, the direction, the inverse and the product (2^-24 of
/// the reach each).
HWY_INLINE bool set_for_boxes(const WideQuery& query, WideRay& ray) {
  float origin[3], direction[3];
  float reach = 0.0f, speed = 0.0f, sum = 0.0f, farthest = 0.0f;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float o = static_cast<float>(query.origin[axis]);
    const float d = static_cast<float>(query.direction[axis]);
    reach = larger(reach, larger(query.bounds[3 + axis] - o, o - query.bounds[axis]));
    farthest = larger(farthest, size_of(o));
    speed = larger(speed, size_of(d));
    sum += o + d;
    origin[axis] = o;
    direction[axis] = d;
  }
  // The sum finds what is not a number.
  const bool is_usable = (reach > smallest_float) & (larger(reach, farthest) < largest_float) &
                         (speed > smallest_float) & (speed < largest_float) & (sum < 8.0f * largest_float);
  if (!is_usable) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float inverse = smaller(larger(1.0f / direction[axis], -largest_inverse), largest_inverse);
    const float margin = 0x1p-20f * reach + 0x1p-22f * size_of(origin[axis]);
    const float forwards = __builtin_copysignf(margin, inverse);
    const auto is_back = static_cast<std::uint32_t>(inverse < 0.0f);
    ray.near_from[axis] = origin[axis] + forwards;
    ray.far_from[axis] = origin[axis] - forwards;
    ray.inverse[axis] = inverse;
    ray.near_row[axis] = static_cast<std::uint32_t>(axis) + 3 * is_back;
    ray.far_row[axis] = static_cast<std::uint32_t>(axis) + 3 - 3 * is_back;
  }
  ray.lower = -not_below(-query.lower);
  ray.upper = not_below(query.upper);
  return true;
}

enum class Aim { first, any };

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

/// Keeps the first of the hits. @return whether there was one
HWY_INLINE bool take(const WideQuery& query, const TriangleBlock& block, const MetTriangles& triangles_met,
                     WideHit& best) {
  bool is_taken = false;
  for (std::uint32_t left = triangles_met.met; left != 0;) {
    const std::size_t lane = take_lowest(left);
    if ((triangles_met.in_doubt >> lane & 1u) != 0) {
      is_taken |= take_in_doubt(query, block, lane, best);
      continue;
    }
    const double t = triangles_met.t[lane];
    const std::uint32_t triangle = block.id[lane];
    if (!is_before(t, triangle, best) || !counts_for(query, triangle)) continue;
    best.t = t;
    best.triangle = triangle;
    for (std::size_t i = 0; i < 3; ++i) best.barycentric[i] = triangles_met.barycentric[i][lane];
    is_taken = true;
  }
  return is_taken;
}

/// The next child that is entered, as they come; the others wait.
HWY_INLINE WideReference one_of(const Places& places, const WideNode& node, std::uint32_t mask,
                                Stack& stack) {
  std::size_t child = take_lowest(mask);
  while (mask != 0) {
    stack.push(Waiting(0.0f, node.child[child]));
    child = take_lowest(mask);
  }
  places.ask_for(node.child[child]);
  return node.child[child];
}

template <Aim aim>
HWY_INLINE bool cast(const WideTreeView& tree, const WideQuery& query, WideHit& hit, WideCounts& counts) {
  WideRay ray;
  if (!set_for_boxes(query, ray)) return false;
  const BoxRay box_ray(ray);
  ExactRay exact_ray;
  bool is_exact = false;
  const Places places(tree);
  WideReference current = tree.root;
  std::uint64_t inner = 0, leaves = 0, tests = 0;
  float upper = ray.upper;
  double limit = query.upper;
  Stack stack;
  for (;;) {
    if (!current.is_block()) {
      ++inner;
      const WideNode& node = places.node(current);
      HWY_ALIGN float entry[8];
      const std::uint32_t mask = entered(box_ray, node, upper, entry);
      if (mask != 0) {
        current =
            aim == Aim::any ? one_of(places, node, mask, stack) : nearest(places, node, mask, entry, stack);
        continue;
      }
    } else {
      ++leaves;
      tests += current.triangles();
      const TriangleBlock& block = places.block(current);
      if (!is_exact) exact_ray.set(query);  // many rays never come here
      is_exact = true;
      const MetTriangles triangles_met(block, exact_ray, query.lower, limit);
      if (triangles_met.met != 0 && take(query, block, triangles_met, hit)) {
        if (aim == Aim::any) break;
        limit = hit.t;
        upper = not_below(limit);
      }
    }
    if (aim == Aim::any) {
      if (stack.is_empty()) break;
      current = stack.pop().below();
    } else if (!take_next(stack, upper, current)) {
      break;
    }
  }
  counts.nodes += inner + leaves;
  counts.boxes += 8 * inner;
  counts.tests += tests;
  return true;
}

}  // namespace

bool cast_wide_first(const WideTreeView& tree, const WideQuery& query, WideHit& hit, WideCounts& counts) {
  return cast<Aim::first>(tree, query, hit, counts);
}

bool cast_wide_any(const WideTreeView& tree, const WideQuery& query, WideHit& hit, WideCounts& counts) {
  return cast<Aim::any>(tree, query, hit, counts);
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

CastWideKernels cast_wide_kernels(Isa isa) {
  static constexpr auto first = VELUM_KERNEL_VERSIONS(cast_wide_first);
  static constexpr auto any = VELUM_KERNEL_VERSIONS(cast_wide_any);
  return {first.at(isa), any.at(isa)};
}

}  // namespace velum
#endif
