/// For kernel files: texels whose four channels go through the arithmetic at once. Read anew for every
/// instruction set, so without `#pragma once`.
#if defined(VELUM_TEXEL_LANES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_TEXEL_LANES_INL_HPP
#undef VELUM_TEXEL_LANES_INL_HPP
#else
#define VELUM_TEXEL_LANES_INL_HPP
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "texture_rows.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace texel_lanes {

namespace hn = hwy::HWY_NAMESPACE;
using Channels = hn::CappedTag<double, 4>;
using FloatChannels = hn::Rebind<float, Channels>;
constexpr Channels channels;
constexpr FloatChannels float_channels;
constexpr std::size_t per_group = hn::MaxLanes(channels);
constexpr std::size_t groups = 4 / per_group;

/// A colour in double, premultiplied; in as many vectors as four channels take.
struct Colour {
  hn::Vec<Channels> of[groups];
};

HWY_INLINE Colour times(const Colour& a, double factor) {
  Colour result;
  for (std::size_t g = 0; g < groups; ++g) result.of[g] = hn::Mul(a.of[g], hn::Set(channels, factor));
  return result;
}
HWY_INLINE Colour sum(const Colour& a, const Colour& b) {
  Colour result;
  for (std::size_t g = 0; g < groups; ++g) result.of[g] = hn::Add(a.of[g], b.of[g]);
  return result;
}
HWY_INLINE Colour blend(const Colour& a, const Colour& b, double share) {
  return sum(times(a, 1.0 - share), times(b, share));
}

/// @param row  counted from below, as texture coordinates do
HWY_INLINE Colour texel(const TextureLevel& level, int column, int row) {
  const float* const at = level.texels + (level.height - 1 - row) * level.stride + std::ptrdiff_t{4} * column;
  Colour result;
  for (std::size_t g = 0; g < groups; ++g)
    result.of[g] = hn::PromoteTo(channels, hn::LoadU(float_channels, at + g * per_group));
  return result;
}

/// elementary::floor() without a call.
HWY_INLINE double floor_of(double x) {
  if (!(x < 0x1p52 && x > -0x1p52)) return x;
  const auto truncated = static_cast<double>(static_cast<std::int64_t>(x));
  return truncated > x ? truncated - 1.0 : truncated;
}

constexpr int clamps = 1, mirrors = 2;

/// in_first_period() of texture_filter.cpp.
HWY_INLINE double in_first_period(double coordinate, int wrap) {
  if (!(coordinate - coordinate == 0.0)) return 0.0;
  if (wrap == clamps) return coordinate < 0.0 ? 0.0 : 1.0 < coordinate ? 1.0 : coordinate;
  if (wrap == mirrors) return coordinate - 2.0 * floor_of(coordinate * 0.5);
  return coordinate - floor_of(coordinate);
}

/// wrapped() of texture_filter.cpp.
HWY_INLINE int wrapped(int i, int size, int wrap) {
  if (wrap == clamps) return i < 0 ? 0 : size - 1 < i ? size - 1 : i;
  const int period = wrap == mirrors ? 2 * size : size;
  if (i < 0) i += period;
  if (i >= period) i -= period;
  return i < size ? i : 2 * size - 1 - i;
}

/// Two neighbouring texels along an axis, and the share of the second.
struct Pair {
  int first, second;
  double share;
};
HWY_INLINE Pair pair_at(double coordinate, int size, int wrap) {
  const double x = in_first_period(coordinate, wrap) * size - 0.5;
  const double whole = floor_of(x);
  const int i = static_cast<int>(whole);
  return {wrapped(i, size, wrap), wrapped(i + 1, size, wrap), x - whole};
}

HWY_INLINE Colour nearest(const TextureLevel& level, double u, double v, const int (&wrap)[2]) {
  const double x = in_first_period(u, wrap[0]) * level.width;
  const double y = in_first_period(v, wrap[1]) * level.height;
  return texel(level, wrapped(static_cast<int>(x), level.width, wrap[0]),
               wrapped(static_cast<int>(y), level.height, wrap[1]));
}

HWY_INLINE Colour bilinear(const TextureLevel& level, double u, double v, const int (&wrap)[2]) {
  const Pair x = pair_at(u, level.width, wrap[0]), y = pair_at(v, level.height, wrap[1]);
  const Colour lower = blend(texel(level, x.first, y.first), texel(level, x.second, y.first), x.share);
  const Colour upper = blend(texel(level, x.first, y.second), texel(level, x.second, y.second), x.share);
  return blend(lower, upper, y.share);
}

}  // namespace texel_lanes
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif
