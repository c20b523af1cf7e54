// The planes around eight rays. Highway reads this file once per instruction set, so its guard turns with the
// target.
#if defined(VELUM_WIDE_BEAM_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_WIDE_BEAM_INL
#undef VELUM_WIDE_BEAM_INL
#else
#define VELUM_WIDE_BEAM_INL
#endif

#include <hwy/highway.h>

#include "wide_packet-inl.hpp"
#include "wide_packet_exact-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// The four planes around the rays: along kz from `start` on, in the direction of the rays, they lie between
/// low + low_slope·way and high + high_slope·way. Places are found in double and only then rounded, so the
/// frustum's margin holds for what follows in float32.
class PacketBeam {
 public:
  HWY_INLINE PacketBeam(const PacketQuery& query, const PacketFrustum& frustum, const PacketLines& lines)
      : axis_{lines.axis[0], lines.axis[1], lines.axis[2]} {
    const std::size_t kz = axis_[2];
    const bool is_back = frustum.inverse_high[kz] < 0.0f;
    sign_ = is_back ? -1.0f : 1.0f;
    // All rays begin beyond here; what lies before the tree is of no interest, nor what lies behind it.
    const double lower = static_cast<double>(query.bounds->lower[kz]),
                 upper = static_cast<double>(query.bounds->upper[kz]);
    const double near = is_back ? -upper : lower, far = is_back ? -lower : upper;
    double first = lines.least_start(static_cast<double>(sign_));
    first = first < near ? near : first;
    first = far < first ? far : first;
    start_ = static_cast<float>(first) - frustum.margin[kz];
    for (std::size_t k = 0; k < 2; ++k) {
      const PacketLines::Sides sides =
          lines.sides_at(k, static_cast<double>(start_), static_cast<double>(sign_));
      low_[k] = static_cast<float>(sides.low) - 4.0f * frustum.margin[axis_[k]];
      high_[k] = static_cast<float>(sides.high) + 4.0f * frustum.margin[axis_[k]];
      low_slope_[k] = static_cast<float>(sides.low_slope);
      high_slope_[k] = static_cast<float>(sides.high_slope);
    }
    start_ = sign_ * start_;
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
  std::size_t axis_[3];
  float sign_, start_;
  float low_[2], high_[2], low_slope_[2], high_slope_[2];
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
