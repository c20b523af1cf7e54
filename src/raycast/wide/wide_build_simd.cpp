#include "wide_build_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raycast/wide/wide_build_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/highway.h>

#include "../../base/simd_dispatch.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Sides = hn::CappedTag<float, 8>;
using Corner = hn::CappedTag<float, 4>;
constexpr Sides sides;
constexpr Corner corner;

constexpr std::uint32_t most_bins = 16;
constexpr float infinity = 3.402823466e38f;  // the largest float is enough

HWY_INLINE void clear(MinBox& box) {
  for (std::size_t i = 0; i < 8; i += hn::Lanes(sides))
    hn::Store(hn::Set(sides, infinity), sides, box.side + i);
}
HWY_INLINE void join(MinBox& box, const MinBox& other) {
  for (std::size_t i = 0; i < 8; i += hn::Lanes(sides)) {
    hn::Store(hn::Min(hn::Load(sides, box.side + i), hn::Load(sides, other.side + i)), sides, box.side + i);
  }
}

/// Twice an item's centre, for some of its axes.
HWY_INLINE hn::Vec<Corner> centre_of(const BuildItem& item, std::size_t first) {
  return hn::Sub(hn::Load(corner, item.side + first), hn::Load(corner, item.side + 4 + first));
}
HWY_INLINE void join_centre(MinBox& box, const BuildItem& item) {
  for (std::size_t i = 0; i < 4; i += hn::Lanes(corner)) {
    const auto centre = centre_of(item, i);
    hn::Store(hn::Min(hn::Load(corner, box.side + i), centre), corner, box.side + i);
    hn::Store(hn::Min(hn::Load(corner, box.side + 4 + i), hn::Neg(centre)), corner, box.side + 4 + i);
  }
}

/// The bins of all axes over some centres.
struct Binning {
  HWY_ALIGN float lower[4];
  HWY_ALIGN float scale[4];
  std::uint32_t count;

  explicit Binning(const BuildRange& range) : lower{}, scale{}, count(4 + range.size() / 8) {
    if (count > most_bins) count = most_bins;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const float size = range.centres.size(axis);
      lower[axis] = range.centres.side[axis];
      // The last centre is in the last bin, and all are in the first where the scale would be none.
      if (size > 1e-30f && size < 1e30f) scale[axis] = static_cast<float>(count) * 0.99999f / size;
    }
  }
  HWY_INLINE void bins_of(const BuildItem& item, std::int32_t* bins) const {
    const hn::RebindToSigned<Corner> ints;
    const auto last = hn::Set(ints, static_cast<std::int32_t>(count) - 1);
    for (std::size_t i = 0; i < 4; i += hn::Lanes(corner)) {
      const auto along = hn::Sub(centre_of(item, i), hn::Load(corner, lower + i));
      const auto bin = hn::ConvertTo(ints, hn::Mul(along, hn::Load(corner, scale + i)));
      hn::Store(hn::Max(hn::Min(bin, last), hn::Zero(ints)), ints, bins + i);
    }
  }
};

struct Bins {
  MinBox box[3][most_bins];
  std::uint32_t count[3][most_bins];
};

HWY_INLINE void fill(Bins& bins, const Binning& binning, const BuildItem* items, const BuildRange& range) {
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    for (std::uint32_t i = 0; i < binning.count; ++i) {
      clear(bins.box[axis][i]);
      bins.count[axis][i] = 0;
    }
  }
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    HWY_ALIGN std::int32_t place[4];
    binning.bins_of(items[i], place);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto bin = static_cast<std::size_t>(place[axis]);
      join(bins.box[axis][bin], items[i]);
      ++bins.count[axis][bin];
    }
  }
}

/// A division between two bins.
struct Division {
  float cost;
  std::uint32_t axis, last_left;
};

/// Blocks of four.
HWY_INLINE float blocks_of(std::uint32_t items) {
  return static_cast<float>((items + 3) / 4);
}

/// From the right the costs of all right sides, then from the left both sides'.
HWY_INLINE void find_cheapest(const Bins& bins, std::uint32_t axis, std::uint32_t bin_count,
                              std::uint32_t items, Division& best) {
  float right_cost[most_bins];
  MinBox box;
  clear(box);
  std::uint32_t count = 0;
  for (std::uint32_t i = bin_count - 1; i > 0; --i) {
    join(box, bins.box[axis][i]);
    count += bins.count[axis][i];
    right_cost[i] = count == 0 ? 0.0f : box.half_area() * blocks_of(count);
  }
  clear(box);
  count = 0;
  for (std::uint32_t i = 0; i + 1 < bin_count; ++i) {
    join(box, bins.box[axis][i]);
    count += bins.count[axis][i];
    if (count == 0 || count == items) continue;
    const float cost = box.half_area() * blocks_of(count) + right_cost[i + 1];
    if (cost < best.cost) best = {cost, axis, i};
  }
}

HWY_INLINE void start(BuildRange& range, std::uint32_t begin, std::uint32_t end) {
  range.begin = begin;
  range.end = end;
  clear(range.box);
  clear(range.centres);
}

/// Exchanges items from both ends until those of the left bins come first.
HWY_INLINE void partition(BuildItem* items, const BuildRange& range, const Binning& binning,
                          const Division& division, BuildRange& left, BuildRange& right) {
  const auto is_left = [&](const BuildItem& item) {
    const float twice_centre = item.side[division.axis] - item.side[4 + division.axis];
    const float bin = (twice_centre - binning.lower[division.axis]) * binning.scale[division.axis];
    return static_cast<std::uint32_t>(bin) <= division.last_left;
  };
  start(left, range.begin, range.begin);
  start(right, range.end, range.end);
  while (left.end < right.begin) {
    if (is_left(items[left.end])) {
      join_centre(left.centres, items[left.end++]);
    } else if (!is_left(items[right.begin - 1])) {
      join_centre(right.centres, items[--right.begin]);
    } else {
      const BuildItem item = items[left.end];
      items[left.end] = items[right.begin - 1];
      items[right.begin - 1] = item;
    }
  }
}

}  // namespace

bool split_items(BuildItem* items, const BuildRange& range, BuildRange& left, BuildRange& right) {
  const Binning binning(range);
  Bins bins;
  fill(bins, binning, items, range);
  Division best{infinity, 0, 0};
  bool is_found = false;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    if (binning.scale[axis] == 0.0f) continue;
    find_cheapest(bins, axis, binning.count, range.size(), best);
    is_found = is_found || best.cost < infinity;
  }
  if (!is_found) return false;
  partition(items, range, binning, best, left, right);
  for (std::uint32_t i = 0; i < binning.count; ++i)
    join(i <= best.last_left ? left.box : right.box, bins.box[best.axis][i]);
  return true;
}

void measure_items(const BuildItem* items, BuildRange& range) {
  start(range, range.begin, range.end);
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    join(range.box, items[i]);
    join_centre(range.centres, items[i]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

WideBuildKernels wide_build_kernels(Isa isa) {
  static constexpr auto split = VELUM_KERNEL_VERSIONS(split_items);
  static constexpr auto measure = VELUM_KERNEL_VERSIONS(measure_items);
  return {split.at(isa), measure.at(isa)};
}

}  // namespace velum
#endif
