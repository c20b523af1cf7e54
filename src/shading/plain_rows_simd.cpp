#include "plain_rows.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/plain_rows_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's header is read anew for every target; it must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"
#include "plain_pixels-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// A row whose pixels follow one another.
struct StoredRow {
  const std::uint32_t* id;
  const float* reversed_depth;

  HWY_INLINE Word ids(std::size_t x) const { return hn::LoadU(words, id + x); }
  HWY_INLINE Word reversed_depths(std::size_t x) const {
    return hn::BitCast(words, hn::LoadU(floats, reversed_depth + x));
  }
  HWY_INLINE std::uint32_t id_at(std::size_t x) const { return id[x]; }
  HWY_INLINE float reversed_depth_at(std::size_t x) const { return reversed_depth[x]; }
};

struct StoredRows {
  const PlainRows& rows;

  HWY_INLINE StoredRow row(std::size_t y) const {
    const auto at = static_cast<std::ptrdiff_t>(y);
    return {rows.ids + at * rows.ids_stride, rows.reversed_depth + at * rows.reversed_depth_stride};
  }
};

}  // namespace

std::uint64_t shade_plain_rows(const PlainRows& rows) {
  return shade_plain(StoredRows{rows}, static_cast<std::size_t>(rows.width),
                     static_cast<std::size_t>(rows.height), rows.out);
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

ShadePlainRows plain_rows_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(shade_plain_rows);
  return isa == Isa::reference ? shade_plain_rows_reference : versions.at(isa);
}

}  // namespace velum
#endif
