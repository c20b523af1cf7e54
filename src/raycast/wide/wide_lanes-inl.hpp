// Eight boxes and four triangles at once. Highway reads this file once per instruction set, so its guard
// turns with the target.
#if defined(VELUM_WIDE_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_LANES_INL
#undef VELUM_WIDE_LANES_INL
#else
#define VELUM_WIDE_LANES_INL
#endif

#include <hwy/highway.h>

#include "wide_kernels.hpp"

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

/// A ray's numbers in every lane, for boxes.
struct BoxRay {
  hn::Vec<Boxes> near_from[3], far_from[3], inverse[3], lower;
  std::size_t near_row[3], far_row[3];

  HWY_INLINE explicit BoxRay(const WideRay& ray) : lower(hn::Set(boxes, ray.lower)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      near_from[axis] = hn::Set(boxes, ray.near_from[axis]);
      far_from[axis] = hn::Set(boxes, ray.far_from[axis]);
      inverse[axis] = hn::Set(boxes, ray.inverse[axis]);
      near_row[axis] = ray.near_row[axis];
      far_row[axis] = ray.far_row[axis];
    }
  }
  /// Where the ray meets the sides of boxes that it enters, or leaves, through.
  HWY_INLINE hn::Vec<Boxes> near(const WideNode& node, std::size_t axis, std::size_t first) const {
    const auto side = hn::Load(boxes, node.bounds[near_row[axis]] + first);
    return hn::Mul(hn::Sub(side, near_from[axis]), inverse[axis]);
  }
  HWY_INLINE hn::Vec<Boxes> far(const WideNode& node, std::size_t axis, std::size_t first) const {
    const auto side = hn::Load(boxes, node.bounds[far_row[axis]] + first);
    return hn::Mul(hn::Sub(side, far_from[axis]), inverse[axis]);
  }
};

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

/// The same for triangles.
struct TriangleRay {
  hn::Vec<Triangles> origin[3], shear_x, shear_y;
  std::size_t axis[3];

  HWY_INLINE explicit TriangleRay(const WideRay& ray)
      : shear_x(hn::Set(triangles, ray.shear_x)), shear_y(hn::Set(triangles, ray.shear_y)) {
    for (std::size_t i = 0; i < 3; ++i) {
      origin[i] = hn::Set(triangles, ray.origin[i]);
      axis[i] = ray.axis[i];
    }
  }
};

/// A corner of some triangles as the ray sees it: see SeenVertex in watertight.cpp.
struct SeenCorners {
  hn::Vec<Triangles> x, y;

  HWY_INLINE SeenCorners(const float (*corner)[4], const TriangleRay& ray, std::size_t first) {
    const auto along = [&](std::size_t i) HWY_ATTR {
      const auto value = hn::PromoteTo(triangles, hn::Load(triangles_in_memory, corner[ray.axis[i]] + first));
      return hn::Sub(value, ray.origin[i]);
    };
    const auto z = along(2);
    x = hn::Sub(along(0), hn::Mul(ray.shear_x, z));
    y = hn::Sub(along(1), hn::Mul(ray.shear_y, z));
  }
};

/// On which side of p → q the ray passes; the operations of intersect_watertight(), so the same bits.
HWY_INLINE hn::Vec<Triangles> edge(const SeenCorners& p, const SeenCorners& q) {
  return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x));
}

/// The triangles that the line of the ray passes with no two edges on opposite sides: one bit each. All that
/// it hits are among them.
HWY_INLINE std::uint32_t perhaps_met(const TriangleBlock& block, const TriangleRay& ray) {
  const auto zero = hn::Zero(triangles);
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < 4; i += hn::Lanes(triangles)) {
    const SeenCorners a(block.corner[0], ray, i), b(block.corner[1], ray, i), c(block.corner[2], ray, i);
    const auto u = edge(b, c), v = edge(c, a), w = edge(a, b);
    const auto least = hn::Min(hn::Min(u, v), w), most = hn::Max(hn::Max(u, v), w);
    mask |= bits_of(triangles, hn::Or(hn::Ge(least, zero), hn::Le(most, zero))) << i;
  }
  return mask;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
