// What eight rays have in common. Highway reads this file once per instruction set, so its guard turns with
// the target.
#if defined(VELUM_WIDE_PACKET_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_PACKET_INL
#undef VELUM_WIDE_PACKET_INL
#else
#define VELUM_WIDE_PACKET_INL
#endif

#include <hwy/highway.h>

#include "wide_float_ray-inl.hpp"
#include "wide_lanes-inl.hpp"
#include "wide_packet_kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// The least and the largest of what all rays have at each of their eight places.
struct PacketExtremes {
  HWY_ALIGN float low[8];
  HWY_ALIGN float high[8];
  HWY_ALIGN float inverse_low[8];  ///< of 1 / number
  HWY_ALIGN float inverse_high[8];
  HWY_ALIGN float sum[8];  ///< NaN where one is

  HWY_INLINE explicit PacketExtremes(const PacketQuery& query) {
    using Doubles = hn::CappedTag<double, 8>;
    constexpr Doubles doubles;
    constexpr hn::Rebind<float, Doubles> floats;
    const auto one = hn::Set(floats, 1.0f);
    for (std::size_t i = 0; i < 8; i += hn::Lanes(doubles)) {
      const auto first = hn::DemoteTo(floats, hn::LoadU(doubles, query.ray(0) + i));
      auto least = first, most = first, total = first;
      auto least_inverse = hn::Div(one, first), most_inverse = least_inverse;
      for (std::size_t r = 1; r < PacketQuery::size; ++r) {
        const auto number = hn::DemoteTo(floats, hn::LoadU(doubles, query.ray(r) + i));
        const auto inverse = hn::Div(one, number);
        least = hn::Min(least, number);
        most = hn::Max(most, number);
        least_inverse = hn::Min(least_inverse, inverse);
        most_inverse = hn::Max(most_inverse, inverse);
        total = hn::Add(total, number);
      }
      hn::Store(least, floats, low + i);
      hn::Store(most, floats, high + i);
      hn::Store(least_inverse, floats, inverse_low + i);
      hn::Store(most_inverse, floats, inverse_high + i);
      hn::Store(total, floats, sum + i);
    }
  }
};

/// The intervals that hold all rays of a packet.
struct PacketFrustum {
  float origin_low[3], origin_high[3], inverse_low[3], inverse_high[3], margin[3];
  float lower, upper;
  bool is_usable = false;

  HWY_INLINE explicit PacketFrustum(const PacketQuery& query) {
    const PacketExtremes extremes(query);
    float reach = 0.0f, speed = 0.0f, farthest = 0.0f;
    bool is_one_way = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      is_one_way &= set_axis(extremes, axis);
      reach = larger(reach, larger(query.bounds->upper[axis] - origin_low[axis],
                                   origin_high[axis] - query.bounds->lower[axis]));
      farthest = larger(farthest, larger(-origin_low[axis], origin_high[axis]));
      const float least = extremes.low[3 + axis], most = extremes.high[3 + axis];
      speed = larger(speed, larger(-least, most));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float origin = larger(size_of(origin_low[axis]), size_of(origin_high[axis]));
      margin[axis] = 0x1p-20f * reach + 0x1p-22f * origin;
    }
    lower = -not_below(-extremes.low[6]);
    upper = not_below(extremes.high[7]);
    is_usable = is_one_way & (reach > smallest_float) & (larger(reach, farthest) < largest_float) &
                (speed > smallest_float) & (speed < largest_float) & (extremes.low[6] > -largest_float) &
                (extremes.sum[6] + extremes.sum[7] == extremes.sum[6] + extremes.sum[7]);
  }

 private:
  /// @return whether all rays go one way along the axis, and no number is NaN
  HWY_INLINE bool set_axis(const PacketExtremes& extremes, std::size_t axis) {
    inverse_low[axis] = extremes.inverse_low[3 + axis];
    inverse_high[axis] = extremes.inverse_high[3 + axis];
    origin_low[axis] = extremes.low[axis];
    origin_high[axis] = extremes.high[axis];
    const bool is_finite = (inverse_low[axis] > -largest_inverse) & (inverse_high[axis] < largest_inverse) &
                           (extremes.sum[axis] + extremes.sum[3 + axis] < 32.0f * largest_float);
    return is_finite & ((inverse_low[axis] > 0.0f) | (inverse_high[axis] < 0.0f));
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

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
