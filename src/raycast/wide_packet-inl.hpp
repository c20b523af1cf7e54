// What eight rays have in common. Highway reads this file once per instruction set, so its guard turns with
// the target.
#if defined(VELUM_WIDE_PACKET_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_PACKET_INL
#undef VELUM_WIDE_PACKET_INL
#else
#define VELUM_WIDE_PACKET_INL
#endif

#include <hwy/highway.h>

#include "wide_lanes-inl.hpp"
#include "wide_packet_kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE float larger(float a, float b) {
  return a > b ? a : b;
}
HWY_INLINE float smaller(float a, float b) {
  return a < b ? a : b;
}
HWY_INLINE float size_of(float v) {
  return v < 0.0f ? -v : v;
}

/// The least and the largest of what all rays have at each of their eight places.
struct PacketExtremes {
  HWY_ALIGN float low[8];
  HWY_ALIGN float high[8];
  HWY_ALIGN float inverse_low[8];  ///< of scale / number
  HWY_ALIGN float inverse_high[8];
  HWY_ALIGN float scaled_low[8];  ///< of scale · number
  HWY_ALIGN float scaled_high[8];
  HWY_ALIGN float sum[8];  ///< NaN where one is

  HWY_INLINE PacketExtremes(const WidePacket& packet, const float* scale) {
    using Doubles = hn::CappedTag<double, 8>;
    constexpr Doubles doubles;
    constexpr hn::Rebind<float, Doubles> floats;
    for (std::size_t i = 0; i < 8; i += hn::Lanes(doubles)) {
      const auto first = hn::DemoteTo(floats, hn::LoadU(doubles, packet.ray[0] + i));
      auto least = first, most = first, total = first;
      auto least_scaled = hn::Mul(first, hn::Set(floats, scale[0])), most_scaled = least_scaled;
      auto least_inverse = hn::Div(hn::Set(floats, scale[0]), first), most_inverse = least_inverse;
      for (std::size_t r = 1; r < WidePacket::size; ++r) {
        const auto number = hn::DemoteTo(floats, hn::LoadU(doubles, packet.ray[r] + i));
        const auto factor = hn::Set(floats, scale[r]);
        const auto inverse = hn::Div(factor, number), scaled = hn::Mul(number, factor);
        least = hn::Min(least, number);
        most = hn::Max(most, number);
        least_inverse = hn::Min(least_inverse, inverse);
        most_inverse = hn::Max(most_inverse, inverse);
        least_scaled = hn::Min(least_scaled, scaled);
        most_scaled = hn::Max(most_scaled, scaled);
        total = hn::Add(total, number);
      }
      hn::Store(least, floats, low + i);
      hn::Store(most, floats, high + i);
      hn::Store(least_inverse, floats, inverse_low + i);
      hn::Store(most_inverse, floats, inverse_high + i);
      hn::Store(least_scaled, floats, scaled_low + i);
      hn::Store(most_scaled, floats, scaled_high + i);
      hn::Store(total, floats, sum + i);
    }
  }
};

/// Within these, nothing overflows, and what underflows is far below the margins.
constexpr float smallest = 1e-15f, largest = 1e15f, largest_inverse = 1e9f;

/// The intervals that hold all rays of a packet. A ray's t is scaled as in WideRay.
struct PacketFrustum {
  std::size_t kx, ky, kz;
  float origin_low[3], origin_high[3], inverse_low[3], inverse_high[3], margin[3];
  float lower, upper;
  float scale[8];
  bool is_usable = false;

  HWY_INLINE explicit PacketFrustum(const WidePacket& packet) {
    choose_axes(packet.ray[0] + 3);
    bool is_scaled = true;
    for (std::size_t r = 0; r < WidePacket::size; ++r) {
      scale[r] = size_of(static_cast<float>(packet.ray[r][3 + kz]));
      is_scaled = is_scaled && scale[r] > smallest && scale[r] < largest;
    }
    if (!is_scaled) return;
    const PacketExtremes extremes(packet, scale);
    float reach = 0.0f;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!set_axis(extremes, axis)) return;
      reach = larger(reach, larger(packet.bounds[1][axis] - origin_low[axis],
                                   origin_high[axis] - packet.bounds[0][axis]));
    }
    if (!(reach > smallest && reach < largest)) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float origin = larger(size_of(origin_low[axis]), size_of(origin_high[axis]));
      margin[axis] = 0x1p-20f * reach + 0x1p-22f * origin;
    }
    // Rounded outwards.
    lower = extremes.scaled_low[6] - size_of(extremes.scaled_low[6]) * 0x1p-20f;
    upper = extremes.scaled_high[7] + size_of(extremes.scaled_high[7]) * 0x1p-20f;
    is_usable = lower > -largest && extremes.sum[7] == extremes.sum[7];
  }

 private:
  HWY_INLINE void choose_axes(const double* direction) {
    const float x = size_of(static_cast<float>(direction[0])), y = size_of(static_cast<float>(direction[1]));
    const float z = size_of(static_cast<float>(direction[2]));
    kz = larger(x, y) > z ? (x > y ? 0 : 1) : 2;
    kx = kz == 2 ? 0 : kz + 1;
    ky = kx == 2 ? 0 : kx + 1;
  }

  /// @return whether all rays go one way along the axis, and none much faster than along kz
  HWY_INLINE bool set_axis(const PacketExtremes& extremes, std::size_t axis) {
    inverse_low[axis] = extremes.inverse_low[3 + axis];
    inverse_high[axis] = extremes.inverse_high[3 + axis];
    origin_low[axis] = extremes.low[axis];
    origin_high[axis] = extremes.high[axis];
    const bool is_finite = inverse_low[axis] > -largest_inverse && inverse_high[axis] < largest_inverse &&
                           size_of(extremes.sum[axis]) < largest && size_of(extremes.sum[3 + axis]) < largest;
    return is_finite && (inverse_low[axis] > 0.5f || inverse_high[axis] < -0.5f) &&
           origin_low[axis] > -largest && origin_high[axis] < largest;
  }
};

/// The frustum's numbers in every lane, for boxes: as BoxRay, with the two ends of each interval.
struct BoxPacket {
  hn::Vec<Boxes> near_from[3], far_from[3], inverse_low[3], inverse_high[3], lower;
  std::size_t near_row[3], far_row[3];

  HWY_INLINE explicit BoxPacket(const PacketFrustum& frustum) : lower(hn::Set(boxes, frustum.lower)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool is_back = frustum.inverse_high[axis] < 0.0f;
      const float low = frustum.origin_low[axis] - frustum.margin[axis];
      const float high = frustum.origin_high[axis] + frustum.margin[axis];
      near_from[axis] = hn::Set(boxes, is_back ? low : high);
      far_from[axis] = hn::Set(boxes, is_back ? high : low);
      inverse_low[axis] = hn::Set(boxes, frustum.inverse_low[axis]);
      inverse_high[axis] = hn::Set(boxes, frustum.inverse_high[axis]);
      near_row[axis] = axis + (is_back ? 3 : 0);
      far_row[axis] = axis + (is_back ? 0 : 3);
    }
  }
  HWY_INLINE hn::Vec<Boxes> near(const WideNode& node, std::size_t axis, std::size_t i) const {
    const auto way = hn::Sub(hn::Load(boxes, node.bounds[near_row[axis]] + i), near_from[axis]);
    return hn::Min(hn::Mul(way, inverse_low[axis]), hn::Mul(way, inverse_high[axis]));
  }
  HWY_INLINE hn::Vec<Boxes> far(const WideNode& node, std::size_t axis, std::size_t i) const {
    const auto way = hn::Sub(hn::Load(boxes, node.bounds[far_row[axis]] + i), far_from[axis]);
    return hn::Max(hn::Mul(way, inverse_low[axis]), hn::Mul(way, inverse_high[axis]));
  }
};

/// The four planes around the rays: along kz from `start` on, in the direction of the rays, they lie between
/// low + low_slope·way and high + high_slope·way.
class PacketBeam {
 public:
  HWY_INLINE PacketBeam(const WidePacket& packet, const PacketFrustum& frustum)
      : axis_{frustum.kx, frustum.ky, frustum.kz} {
    const std::size_t kz = frustum.kz;
    const bool is_back = frustum.inverse_high[kz] < 0.0f;
    sign_ = is_back ? -1.0f : 1.0f;
    // All rays begin beyond here.
    const float first = is_back ? frustum.origin_high[kz] : frustum.origin_low[kz];
    start_ = first + sign_ * (frustum.lower - frustum.margin[kz]);
    for (std::size_t k = 0; k < 2; ++k) set_sides(packet, frustum, k);
  }

  /// The triangles of a block that are not outside one of the planes: one bit each.
  HWY_INLINE std::uint32_t perhaps_met(const TriangleBlock& block) const {
    using Four = hn::CappedTag<float, 4>;
    constexpr Four four;
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < 4; i += hn::Lanes(four)) {
      std::uint32_t outside = 0;
      hn::Vec<Four> way[3];
      for (std::size_t c = 0; c < 3; ++c) {
        const auto z = hn::Load(four, block.corner[c][axis_[2]] + i);
        way[c] = hn::Mul(hn::Sub(z, hn::Set(four, start_)), hn::Set(four, sign_));
      }
      for (std::size_t k = 0; k < 2; ++k) {
        const auto beyond = [&](std::size_t c, float from, float slope) HWY_ATTR {
          const auto place = hn::Load(four, block.corner[c][axis_[k]] + i);
          return hn::Sub(hn::Sub(place, hn::Set(four, from)), hn::Mul(way[c], hn::Set(four, slope)));
        };
        const auto low = [&](std::size_t c) HWY_ATTR { return beyond(c, low_[k], low_slope_[k]); };
        const auto high = [&](std::size_t c) HWY_ATTR { return beyond(c, high_[k], high_slope_[k]); };
        const auto most = hn::Max(hn::Max(low(0), low(1)), low(2));
        const auto least = hn::Min(hn::Min(high(0), high(1)), high(2));
        const auto zero = hn::Zero(four);
        outside |= bits_of(four, hn::Or(hn::Lt(most, zero), hn::Gt(least, zero)));
      }
      mask |= (~outside & ((1u << hn::Lanes(four)) - 1u)) << i;
    }
    return mask;
  }

 private:
  HWY_INLINE void set_sides(const WidePacket& packet, const PacketFrustum& frustum, std::size_t k) {
    float low = largest, high = -largest;
    low_slope_[k] = largest;
    high_slope_[k] = -largest;
    for (std::size_t r = 0; r < WidePacket::size; ++r) {
      const double* ray = packet.ray[r];
      const float slope = static_cast<float>(ray[3 + axis_[k]]) / frustum.scale[r];
      const float way = (start_ - static_cast<float>(ray[axis_[2]])) * sign_;
      const float place = static_cast<float>(ray[axis_[k]]) + way * slope;
      low = smaller(low, place);
      high = larger(high, place);
      low_slope_[k] = smaller(low_slope_[k], slope);
      high_slope_[k] = larger(high_slope_[k], slope);
    }
    low_[k] = low - 4.0f * frustum.margin[axis_[k]];
    high_[k] = high + 4.0f * frustum.margin[axis_[k]];
  }

  std::size_t axis_[3];
  float sign_, start_;
  float low_[2], high_[2], low_slope_[2], high_slope_[2];
};

/// Eight rays against one triangle, the operations of intersect_watertight(): see perhaps_met() in
/// wide_lanes-inl.hpp, with rays in the lanes. @return one bit per ray
HWY_INLINE std::uint32_t rays_that_meet(const TriangleBlock& block, std::size_t triangle,
                                        const WideLines& lines) {
  using Rays = hn::CappedTag<double, WidePacket::size>;
  constexpr Rays rays;
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < WidePacket::size; i += hn::Lanes(rays)) {
    hn::Vec<Rays> x[3], y[3];
    for (std::size_t c = 0; c < 3; ++c) {
      const auto along = [&](std::size_t k) HWY_ATTR {
        const auto value = static_cast<double>(block.corner[c][lines.axis[k]][triangle]);
        return hn::Sub(hn::Set(rays, value), hn::Load(rays, lines.origin[k] + i));
      };
      const auto z = along(2);
      x[c] = hn::Sub(along(0), hn::Mul(hn::Load(rays, lines.shear_x + i), z));
      y[c] = hn::Sub(along(1), hn::Mul(hn::Load(rays, lines.shear_y + i), z));
    }
    const auto edge = [&](std::size_t p, std::size_t q)
                          HWY_ATTR { return hn::Sub(hn::Mul(x[p], y[q]), hn::Mul(y[p], x[q])); };
    const auto u = edge(1, 2), v = edge(2, 0), w = edge(0, 1), zero = hn::Zero(rays);
    const auto least = hn::Min(hn::Min(u, v), w), most = hn::Max(hn::Max(u, v), w);
    mask |= bits_of(rays, hn::Or(hn::Ge(least, zero), hn::Le(most, zero))) << i;
  }
  return mask;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
