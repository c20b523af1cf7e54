// Eight boxes and four triangles at once. Highway reads this file once per instruction set, so its guard
// turns with the target.
#if defined(VELUM_WIDE_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_LANES_INL
#undef VELUM_WIDE_LANES_INL
#else
#define VELUM_WIDE_LANES_INL
#endif

#include <hwy/highway.h>

#include "wide_nodes.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Boxes = hn::CappedTag<float, 8>;
using Triangles = hn::CappedTag<double, 4>;
using TrianglesInMemory = hn::Rebind<float, Triangles>;
constexpr Boxes boxes;
constexpr Triangles triangles;
constexpr TrianglesInMemory triangles_in_memory;

/// One bit per lane, the first lane lowest. @pre at most eight lanes
template <typename Tag>
HWY_INLINE std::uint32_t bits_of(Tag tag, hn::Mask<Tag> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(tag, mask, bytes);
  return bytes[0];
}

/// Which of the eight boxes a ray, or any ray of a packet, goes into before `upper`: one bit each.
/// @param ray    a BoxRay or BoxPacket
/// @param entry  where
template <typename Ray>
HWY_INLINE std::uint32_t entered(const Ray& ray, const WideNode& node, float upper, float* entry) {
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < 8; i += hn::Lanes(boxes)) {
    const auto enter = hn::Max(hn::Max(ray.near(node, 0, i), ray.near(node, 1, i)),
                               hn::Max(ray.near(node, 2, i), ray.lower));
    const auto leave = hn::Min(hn::Min(ray.far(node, 0, i), ray.far(node, 1, i)),
                               hn::Min(ray.far(node, 2, i), hn::Set(boxes, upper)));
    hn::Store(enter, boxes, entry + i);
    mask |= bits_of(boxes, hn::Le(enter, leave)) << i;
  }
  return mask;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
