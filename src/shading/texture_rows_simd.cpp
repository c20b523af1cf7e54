#include "texture_rows.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/texture_rows_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's header is read anew for every target; it must follow the line above.
#include <hwy/highway.h>

#include "../base/elementary_vectors.hpp"
#include "../base/simd_dispatch.hpp"
#include "texel_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

using namespace elementary_vectors;
using texel_lanes::Colour;
using Floats = hn::Rebind<float, Doubles>;
using Float = hn::Vec<Floats>;
constexpr Floats floats;
constexpr std::size_t most_lanes = 8;

/// What is looked up for each pixel of a vector; see probed() of texture_filter.cpp.
struct Lookups {
  alignas(64) double at[2][most_lanes];
  alignas(64) double step[2][most_lanes];  ///< from probe to probe
  alignas(64) double steps[most_lanes];    ///< probes to each side
  alignas(64) double level[most_lanes];
  alignas(64) double next[most_lanes];  ///< share of the next level
  alignas(64) double is_mean[most_lanes];
};

struct Pair {
  Double x, y;
};

/// Footprint of texture_filter.cpp.
struct Footprint {
  Double longer, shorter;
  Pair along;
};
HWY_INLINE Footprint footprint_of(const RowTexture& texture, const Pair& dx, const Pair& dy) {
  const Double half = all(0.5), zero = hn::Zero(doubles);
  const Pair size = {all(static_cast<double>(texture.levels[0].width)),
                     all(static_cast<double>(texture.levels[0].height))};
  const Pair a = {product(dx.x, size.x), product(dx.y, size.y)};
  const Pair b = {product(dy.x, size.x), product(dy.y, size.y)};
  const Double uv = sum(product(a.x, a.y), product(b.x, b.y));
  const Double xx = sum(product(a.x, a.x), product(b.x, b.x));
  const Double ay = product(a.y, a.y), by = product(b.y, b.y);
  const Double mean = product(half, sum(sum(xx, ay), by));
  const Double half_difference = product(half, difference(difference(xx, ay), by));
  const Double root = hn::Sqrt(sum(product(half_difference, half_difference), product(uv, uv)));
  const Double longer = hn::Sqrt(sum(mean, root));
  const auto has_size = hn::Gt(longer, zero);
  const Double shorter = hn::Div(hn::Abs(difference(product(a.x, b.y), product(a.y, b.x))), longer);
  const auto is_across = hn::Ge(half_difference, zero);
  const Pair direction = {hn::IfThenElse(is_across, sum(half_difference, root), uv),
                          hn::IfThenElse(is_across, uv, difference(root, half_difference))};
  const Double length = hn::Sqrt(sum(product(direction.x, direction.x), product(direction.y, direction.y)));
  const auto has_direction = hn::And(has_size, hn::Gt(length, zero));
  const Double stretch = hn::Div(longer, length);
  return {longer,
          hn::IfThenElseZero(has_size, shorter),
          {hn::IfThenElseZero(has_direction, hn::Div(product(direction.x, stretch), size.x)),
           hn::IfThenElseZero(has_direction, hn::Div(product(direction.y, stretch), size.y))}};
}

HWY_INLINE Double larger(Double a, Double b) {
  return hn::IfThenElse(hn::Lt(a, b), b, a);
}

/// Level of detail and probes of several pixels: filtered_by_area() and probed() up to the first texel.
HWY_INLINE void measure(const RowTexture& texture, const Footprint& footprint, Lookups& lookups) {
  const Double zero = hn::Zero(doubles), one = all(1.0);
  const auto is_bounded = hn::Lt(footprint.longer, all(0x1p40));
  const Double sixteenth = hn::Div(footprint.longer, all(16.0));
  const Double length = larger(larger(footprint.shorter, sixteenth), one);
  const auto is_smaller = hn::And(is_bounded, hn::Gt(length, one));
  const Double lambda =
      product(elementary_vectors::log(hn::IfThenElse(is_smaller, length, one)), all(1.44269504088896340736));
  const Double last = all(static_cast<double>(texture.level_count - 1));
  const auto is_last = hn::Ge(lambda, last);
  const Double level = hn::Floor(lambda);
  hn::Store(hn::IfThenElse(is_last, last, level), doubles, lookups.level);
  hn::Store(hn::IfThenZeroElse(is_last, difference(lambda, level)), doubles, lookups.next);
  const auto is_long = hn::And(is_bounded, hn::Gt(footprint.longer, length));
  const Double square = product(footprint.longer, footprint.longer);
  const Double reach = hn::Sqrt(difference(square, product(length, length)));
  const Double steps = hn::Ceil(hn::Div(product(all(1.5), reach), length));
  const Double stride = hn::Div(hn::Div(reach, footprint.longer), steps);
  hn::Store(hn::IfThenElseZero(is_long, steps), doubles, lookups.steps);
  hn::Store(product(footprint.along.x, stride), doubles, lookups.step[0]);
  hn::Store(product(footprint.along.y, stride), doubles, lookups.step[1]);
  hn::Store(hn::IfThenElse(is_bounded, zero, one), doubles, lookups.is_mean);
}

HWY_INLINE Double mapped(const double* coordinates, double scale) {
  return product(hn::LoadU(doubles, coordinates), all(scale));
}

HWY_INLINE void look_up(const RowTexture& texture, const SurfaceRow& row, std::size_t i, Lookups& lookups) {
  for (int k = 0; k < 2; ++k) {
    const Double at = sum(mapped(row.texture_at[k] + i, texture.scale[k]), all(texture.offset[k]));
    hn::Store(at, doubles, lookups.at[k]);
  }
  if (texture.filter != 2) return;
  const Pair dx = {mapped(row.texture_dx[0] + i, texture.scale[0]),
                   mapped(row.texture_dx[1] + i, texture.scale[1])};
  const Pair dy = {mapped(row.texture_dy[0] + i, texture.scale[0]),
                   mapped(row.texture_dy[1] + i, texture.scale[1])};
  measure(texture, footprint_of(texture, dx, dy), lookups);
}

/// trilinear() of texture_filter.cpp.
HWY_INLINE Colour trilinear(const RowTexture& texture, int level, double next, double u, double v) {
  const Colour finer = texel_lanes::bilinear(texture.levels[level], u, v, texture.wrap);
  if (next == 0.0) return finer;
  return texel_lanes::blend(finer, texel_lanes::bilinear(texture.levels[level + 1], u, v, texture.wrap),
                            next);
}

/// probed() of texture_filter.cpp from its first texel on.
HWY_INLINE Colour probed(const RowTexture& texture, const Lookups& lookups, std::size_t lane) {
  const int level = static_cast<int>(lookups.level[lane]);
  const double next = lookups.next[lane], u = lookups.at[0][lane], v = lookups.at[1][lane];
  Colour total = trilinear(texture, level, next, u, v);
  const int steps = static_cast<int>(lookups.steps[lane]);
  if (steps == 0) return total;
  double weights = 1.0;
  for (int i = 1; i <= steps; ++i) {
    const double weight = texture.weights[steps][i];
    const double across = lookups.step[0][lane] * i, up = lookups.step[1][lane] * i;
    const Colour both = texel_lanes::sum(trilinear(texture, level, next, u - across, v - up),
                                         trilinear(texture, level, next, u + across, v + up));
    total = texel_lanes::sum(total, texel_lanes::times(both, weight));
    weights += 2.0 * weight;
  }
  for (auto& group : total.of) group = hn::Div(group, hn::Set(texel_lanes::channels, weights));
  return total;
}

HWY_INLINE Colour filtered(const RowTexture& texture, const Lookups& lookups, std::size_t lane) {
  const TextureLevel& picture = texture.levels[0];
  const double u = lookups.at[0][lane], v = lookups.at[1][lane];
  if (texture.filter == 0) return texel_lanes::nearest(picture, u, v, texture.wrap);
  if (texture.filter == 1) return texel_lanes::bilinear(picture, u, v, texture.wrap);
  if (lookups.is_mean[lane] == 0.0) return probed(texture, lookups, lane);
  const TextureLevel& last = texture.levels[texture.level_count - 1];
  return texel_lanes::texel(last, 0, last.height - 1);
}

/// straight() of texture_filter.cpp.
HWY_INLINE void store_straight(const Colour& colour, bool is_opaque, std::size_t i, SurfaceRow& row) {
  alignas(32) double c[4];
  for (std::size_t g = 0; g < texel_lanes::groups; ++g)
    hn::StoreU(colour.of[g], texel_lanes::channels, c + g * texel_lanes::per_group);
  const bool is_seen = c[3] > 0.0;
  for (int k = 0; k < 3; ++k) {
    const double straight = is_opaque ? c[k] : is_seen ? c[k] / c[3] : 0.0;
    row.texel[k][i] = static_cast<float>(straight);
  }
  row.texel[3][i] = is_opaque ? 1.0f : is_seen ? static_cast<float>(c[3]) : 0.0f;
}

HWY_INLINE Float interpolated(const float (&plane)[3], Float y, Float z) {
  const Float first = hn::Add(hn::Set(floats, plane[0]), hn::Mul(hn::Set(floats, plane[1]), y));
  return hn::Add(first, hn::Mul(hn::Set(floats, plane[2]), z));
}

/// The texel colours what the surface scatters, not its highlight: textured() of shade.cpp.
HWY_INLINE void apply(const TrianglePlanes& t, std::size_t i, SurfaceRow& row) {
  const Float y = hn::LoadU(floats, row.barycentric[1] + i), z = hn::LoadU(floats, row.barycentric[2] + i);
  for (int c = 0; c < 4; ++c) {
    const Float texel = hn::LoadU(floats, row.texel[c] + i), lit = hn::LoadU(floats, row.colour[c] + i);
    if (c == 3 || !t.has_highlight) {
      hn::StoreU(hn::Mul(lit, texel), floats, row.colour[c] + i);
      continue;
    }
    const Float highlight = interpolated(t.highlight[c], y, z);
    const Float scattered = hn::Mul(hn::Sub(lit, highlight), texel);
    hn::StoreU(hn::Add(highlight, scattered), floats, row.colour[c] + i);
  }
}

}  // namespace

void texture_row(const TexturingWork& work) {
  const RowTexture& texture = *work.texture;
  SurfaceRow& row = *work.row;
  const std::size_t lanes = hn::Lanes(doubles);
  Lookups lookups{};
  for (std::size_t i = work.begin; i < work.end; i += lanes) {
    look_up(texture, row, i, lookups);
    const std::size_t left = work.end - i, count = left < lanes ? left : lanes;
    for (std::size_t lane = 0; lane < count; ++lane)
      store_straight(filtered(texture, lookups, lane), texture.is_opaque, i + lane, row);
    apply(*work.triangle, i, row);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

TextureRow texture_row_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(texture_row);
  return versions.at(isa);
}

}  // namespace velum
#endif
