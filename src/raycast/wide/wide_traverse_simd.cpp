#include "wide_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/wide/wide_traverse_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/highway.h>

#include "../../base/simd_dispatch.hpp"
#include "wide_lanes-inl.hpp"
#include "wide_stack-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {

void traverse_wide(const WideTreeView& tree, const WideRay& ray, const WideMeeting& meeting,
                   WideCounts& counts) {
  const BoxRay box_ray(ray);
  const TriangleRay triangle_ray(ray);
  const Places places(tree);
  WideReference current = tree.root;
  std::uint64_t inner = 0, leaves = 0, tests = 0;
  float upper = ray.upper;
  Stack stack;
  for (bool is_left = true; is_left;) {
    if (!current.is_block()) {
      ++inner;
      const WideNode& node = places.node(current);
      HWY_ALIGN float entry[8];
      const std::uint32_t mask = entered(box_ray, node, upper, entry);
      if (mask != 0) {
        current = nearest(places, node, mask, entry, stack);
        continue;
      }
    } else {
      ++leaves;
      tests += current.triangles();
      const TriangleBlock& block = places.block(current);
      const std::uint32_t lanes = perhaps_met(block, triangle_ray);
      if (lanes != 0) upper = meeting.meet(meeting.context, block, lanes);
    }
    is_left = take_next(stack, upper, current);
  }
  counts.nodes += inner + leaves;
  counts.boxes += 8 * inner;
  counts.tests += tests;
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

TraverseWide traverse_wide_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(traverse_wide);
  return versions.at(isa);
}

}  // namespace velum
#endif
