#include "geometry_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/transform_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's header is read anew for every target; it must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"
#include "clip_position-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

constexpr std::size_t most_lanes = 8;

/// Adds bit `bit` to the codes of the lanes whose value is negative or NaN.
HWY_INLINE Double with_bit(Double codes, int bit, Double value) {
  const Double code = hn::Set(doubles, static_cast<double>(1 << bit));
  return hn::Add(codes, hn::IfThenZeroElse(hn::Ge(value, hn::Zero(doubles)), code));
}

/// The outcodes, as numbers; in the order of the table in clipping/outcode.hpp.
HWY_INLINE Double outcodes_of(const ClipVector& v) {
  // The table's z - 0·w tells an infinite w, too.
  const Double front = hn::Sub(v.z, hn::Mul(hn::Zero(doubles), v.w));
  Double codes = with_bit(hn::Zero(doubles), 0, front);
  codes = with_bit(codes, 1, hn::Sub(v.w, v.z));
  codes = with_bit(codes, 2, hn::Add(v.x, v.w));
  codes = with_bit(codes, 3, hn::Sub(v.w, v.x));
  codes = with_bit(codes, 4, hn::Add(v.y, v.w));
  return with_bit(codes, 5, hn::Sub(v.w, v.y));
}

/// floor(pixel · 256 + 0.5)
HWY_INLINE hn::Vec<NarrowInts> snapped(Double pixel) {
  const Double scaled = hn::Add(hn::Mul(pixel, hn::Set(doubles, 256.0)), hn::Set(doubles, 0.5));
  return hn::DemoteTo(narrow_ints, hn::Floor(scaled));
}

/// A vertex on the picture, pixels.
struct Place {
  Double x, y;
};
HWY_INLINE Place place_of(const TransformWork& work, const ClipVector& v) {
  const Double one = hn::Set(doubles, 1.0);
  const Double half_width = hn::Set(doubles, 0.5 * work.width);
  const Double half_height = hn::Set(doubles, 0.5 * work.height);
  return {hn::Mul(half_width, hn::Add(hn::Div(v.x, v.w), one)),
          hn::Mul(half_height, hn::Sub(one, hn::Div(v.y, v.w)))};
}

/// Whether all outcodes are 0 and all w positive.
HWY_INLINE bool are_all_inside(const ClipVector& v) {
  const Double zero = hn::Zero(doubles);
  const auto depth = hn::And(hn::Ge(hn::Sub(v.z, hn::Mul(zero, v.w)), zero), hn::Ge(hn::Sub(v.w, v.z), zero));
  const auto columns = hn::And(hn::Ge(hn::Add(v.x, v.w), zero), hn::Ge(hn::Sub(v.w, v.x), zero));
  const auto rows = hn::And(hn::Ge(hn::Add(v.y, v.w), zero), hn::Ge(hn::Sub(v.w, v.y), zero));
  const auto inside = hn::And(hn::And(depth, columns), hn::And(rows, hn::Gt(v.w, zero)));
  return hn::AllTrue(doubles, inside);
}

HWY_INLINE void place_inside(const TransformWork& work, const ClipVector& v, PlacedVertex* out) {
  const Place at = place_of(work, v);
  hn::StoreInterleaved2(snapped(at.x), snapped(at.y), narrow_ints, reinterpret_cast<std::int32_t*>(out));
}

HWY_INLINE void place(const TransformWork& work, const ClipVector& v, Double codes, PlacedVertex* out) {
  const Place at = place_of(work, v);
  const auto inside = hn::And(hn::Eq(codes, hn::Zero(doubles)), hn::Gt(v.w, hn::Zero(doubles)));
  const Double x_or_none = hn::IfThenElseZero(inside, at.x);
  const Double y_or_none = hn::IfThenElseZero(inside, at.y);
  const Double sum = hn::Add(hn::Add(v.x, v.y), hn::Add(v.z, v.w));
  const Double code = hn::IfThenElseZero(hn::Eq(hn::Sub(sum, sum), hn::Zero(doubles)), codes);
  const auto nowhere = hn::Set(narrow_ints, not_snapped);
  const auto is_inside = hn::Eq(hn::DemoteTo(narrow_ints, hn::IfThenElseZero(inside, hn::Set(doubles, 1.0))),
                                hn::Set(narrow_ints, 1));
  hn::StoreInterleaved2(hn::IfThenElse(is_inside, snapped(x_or_none), nowhere),
                        hn::IfThenElse(is_inside, snapped(y_or_none), hn::DemoteTo(narrow_ints, code)),
                        narrow_ints, reinterpret_cast<std::int32_t*>(out));
}

/// What set_up_depth() finds of the vertices of a triangle: SmallTriangle::upper is the largest of the three.
HWY_INLINE void store_nearness(const ClipVector& v, float* out) {
  const Double r = hn::Mul(hn::Sub(v.w, v.z), hn::Div(hn::Set(doubles, 1.0), v.w));
  hn::StoreU(hn::DemoteTo(narrow_floats, unit(r)), narrow_floats, out);
}

HWY_INLINE void transform_lanes(const TransformWork& work, const float* positions, double* clip,
                                std::uint8_t* outcodes, PlacedVertex* placed, float* nearness) {
  hn::Vec<NarrowFloats> px, py, pz;
  hn::LoadInterleaved3(narrow_floats, positions, px, py, pz);
  const ClipVector v = clip_position(work.clip_from_object, px, py, pz);
  if (nearness != nullptr) store_nearness(v, nearness);
  if (clip == nullptr && outcodes == nullptr && are_all_inside(v)) return place_inside(work, v, placed);
  if (clip != nullptr) hn::StoreInterleaved4(v.x, v.y, v.z, v.w, doubles, clip);
  const Double codes = outcodes_of(v);
  if (outcodes != nullptr) {
    HWY_ALIGN std::int32_t code[most_lanes];
    hn::Store(hn::DemoteTo(narrow_ints, codes), narrow_ints, code);
    for (std::size_t i = 0; i < hn::Lanes(doubles); ++i) outcodes[i] = static_cast<std::uint8_t>(code[i]);
  }
  place(work, v, codes, placed);
}

}  // namespace

void transform_positions(const TransformWork& given) {
  // A copy of its own, which no store can change: it stays in registers.
  TransformWork work = given;
  double matrix[16];
  for (int k = 0; k < 16; ++k) matrix[k] = given.clip_from_object[k];
  work.clip_from_object = matrix;
  const std::size_t lanes = hn::Lanes(doubles);
  std::size_t i = 0;
  for (; i + lanes <= work.count; i += lanes) {
    transform_lanes(work, work.positions + 3 * i, work.clip == nullptr ? nullptr : work.clip + 4 * i,
                    work.outcodes == nullptr ? nullptr : work.outcodes + i, work.placed + i,
                    work.nearness == nullptr ? nullptr : work.nearness + i);
  }
  if (i == work.count) return;
  // The rest, in memory where whole vectors fit.
  float positions[3 * most_lanes] = {};
  double clip[4 * most_lanes] = {};
  std::uint8_t outcodes[most_lanes] = {};
  PlacedVertex placed[most_lanes] = {};
  float nearness[most_lanes] = {};
  const std::size_t rest = work.count - i;
  for (std::size_t k = 0; k < 3 * rest; ++k) positions[k] = work.positions[3 * i + k];
  transform_lanes(work, positions, clip, outcodes, placed, nearness);
  for (std::size_t k = 0; work.clip != nullptr && k < 4 * rest; ++k) work.clip[4 * i + k] = clip[k];
  for (std::size_t k = 0; work.outcodes != nullptr && k < rest; ++k) work.outcodes[i + k] = outcodes[k];
  for (std::size_t k = 0; k < rest; ++k) work.placed[i + k] = placed[k];
  for (std::size_t k = 0; work.nearness != nullptr && k < rest; ++k) work.nearness[i + k] = nearness[k];
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

TransformVertices transform_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(transform_positions);
  return versions.at(isa);
}

}  // namespace velum
#endif
