#include "empty_triangles.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/empty_triangles_simd.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// Highway's headers are read anew for every target; they must follow the line above.
#include <hwy/highway.h>

#include "../base/simd_dispatch.hpp"
#include "empty_triangles_window.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {

// One lane holds no pair of coordinates: there the plain loop is the kernel.
#if HWY_TARGET == HWY_SCALAR

std::uint32_t leave_out_empty(const EmptyTrianglesWork& work, Counters& counters) {
  return leave_out_empty_reference(work, counters);
}

#else

namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Ints = hn::CappedTag<std::int32_t, 16>;
using Int = hn::Vec<Ints>;
using IntMask = hn::Mask<Ints>;
constexpr Ints ints;

using Indices = hn::Rebind<std::uint16_t, Ints>;
constexpr Indices indices;

HWY_INLINE std::size_t lanes() {
  return hn::Lanes(ints);
}

/// Packs the vertices: y in the upper, x in the lower half of a word, counted from a corner of the first
/// one's pixel. @return their window; unless it is narrow what is packed means nothing
HWY_INLINE PlacedWindow pack(const EmptyTrianglesWork& work) {
  const PlacedVertex* const placed = work.placed + work.first_vertex;
  const std::int32_t origin_x = placed->x & -256, origin_y = placed->y & -256;
  const Int from_x = hn::Set(ints, origin_x), from_y = hn::Set(ints, origin_y);
  const Int low_half = hn::Set(ints, 0xFFFF);
  Int left = hn::Set(ints, INT32_MAX), top = left, right = hn::Set(ints, INT32_MIN), bottom = right;
  std::size_t i = 0;
  for (; i + lanes() <= work.vertex_count; i += lanes()) {
    Int x, y;
    hn::LoadInterleaved2(ints, reinterpret_cast<const std::int32_t*>(placed + i), x, y);
    left = hn::Min(left, x);
    right = hn::Max(right, x);
    top = hn::Min(top, y);
    bottom = hn::Max(bottom, y);
    const Int column = hn::And(hn::Sub(x, from_x), low_half);
    hn::StoreU(hn::Or(column, hn::ShiftLeft<16>(hn::Sub(y, from_y))), ints, work.scratch + i);
  }
  PlacedBox box{hn::GetLane(hn::MinOfLanes(ints, left)), hn::GetLane(hn::MinOfLanes(ints, top)),
                hn::GetLane(hn::MaxOfLanes(ints, right)), hn::GetLane(hn::MaxOfLanes(ints, bottom))};
  for (; i < work.vertex_count; ++i) {
    box.include(placed[i]);
    const auto x = static_cast<std::uint32_t>(placed[i].x) - static_cast<std::uint32_t>(origin_x);
    const auto y = static_cast<std::uint32_t>(placed[i].y) - static_cast<std::uint32_t>(origin_y);
    work.scratch[i] = static_cast<std::int32_t>((x & 0xFFFFu) | (y << 16));
  }
  return window_around(box);
}

/// Looks vertices up one by one.
HWY_INLINE Int in_memory(const std::int32_t* packed, const std::uint16_t* corners, IntMask present) {
  const Int index = hn::PromoteTo(ints, hn::LoadU(indices, corners));
  return hn::GatherIndex(ints, packed, hn::IfThenElseZero(present, index));
}

constexpr std::size_t most_window_vectors = window_corners / hn::MaxLanes(ints);

/// Holds the vertices of a window and looks them up by the lane.
class InWindow {
 public:
  HWY_INLINE InWindow(const std::int32_t* packed, std::uint16_t first) : first_(hn::Set(ints, first)) {
    for (std::size_t i = 0; i < most_window_vectors; ++i) {
      part_[i] = hn::LoadU(ints, packed + first + i * lanes());
    }
  }
  HWY_INLINE Int operator()(const std::uint16_t* corners) const {
    const Int index = hn::Sub(hn::PromoteTo(ints, hn::LoadU(indices, corners)), first_);
    const Int lane = hn::And(index, hn::Set(ints, static_cast<std::int32_t>(lanes() - 1)));
    return among<0, most_window_vectors>(index, hn::IndicesFromVec(ints, lane));
  }

 private:
  template <std::size_t first, std::size_t size, typename Lanes>
  HWY_INLINE Int among(Int index, Lanes lane) const {
    if constexpr (size == 1) {
      return hn::TableLookupLanes(part_[first], lane);
    } else {
      constexpr std::size_t half = size / 2;
      const Int bit = hn::Set(ints, static_cast<std::int32_t>(half * lanes()));
      return hn::IfThenElse(hn::TestBit(index, bit), among<first + half, half>(index, lane),
                            among<first, half>(index, lane));
    }
  }

  Int first_;
  Int part_[most_window_vectors];
};

using Halves = hn::Repartition<std::int16_t, Ints>;
using Half = hn::Vec<Halves>;  // x and y in turn, as packed
constexpr Halves halves;

/// What is known of a vector of triangles.
struct Found {
  IntMask is_empty;  ///< covers no pixel centre, for sure
  Int area;          ///< doubled, of those that do not
};

/// (x, y) turned to (y, -x).
HWY_INLINE Half turned(Half v) {
  const Int both = hn::BitCast(ints, v);
  const Int low_half = hn::Set(ints, 0xFFFF);
  const Half swapped =
      hn::BitCast(halves, hn::Or(hn::ShiftLeft<16>(both), hn::And(hn::ShiftRight<16>(both), low_half)));
  const Half sign = hn::BitCast(halves, hn::Set(ints, -65536));
  return hn::Sub(hn::Xor(swapped, sign), sign);
}

/// x·x' + y·y'
HWY_INLINE Int dot(Half a, Half b) {
  Int odd = hn::Zero(ints);
  const Int even = hn::ReorderWidenMulAccumulate(ints, a, b, hn::Zero(ints), odd);
  return hn::RearrangeToOddPlusEven(even, odd);
}

/// See leave_out_empty_reference: columns and rows at once, seen from the centre of the first pixel that has
/// its centre beyond the smallest coordinates.
HWY_INLINE Found look_at(Int packed_a, Int packed_b, Int packed_c) {
  Half a = hn::BitCast(halves, packed_a), b = hn::BitCast(halves, packed_b),
       c = hn::BitCast(halves, packed_c);
  const Half to_centre = hn::Set(halves, std::int16_t{128});
  const Half lowest = hn::Min(a, hn::Min(b, c)), highest = hn::Max(a, hn::Max(b, c));
  const Half first = hn::ShiftRight<8>(hn::Add(lowest, hn::Set(halves, std::int16_t{127})));
  const Half last = hn::ShiftRight<8>(hn::Sub(highest, to_centre));
  const Half centre = hn::Add(hn::ShiftLeft<8>(first), to_centre);
  a = hn::Sub(a, centre);
  b = hn::Sub(b, centre);
  c = hn::Sub(c, centre);
  const Int edges[3] = {dot(a, turned(b)), dot(b, turned(c)), dot(c, turned(a))};
  // Signs: the centre lies left of one edge and right of another, and is the only one.
  const Int some_negative = hn::Or(edges[0], hn::Or(edges[1], edges[2]));
  const Int zero = hn::Zero(ints);
  const Int highest_edge = hn::Max(edges[0], hn::Max(edges[1], edges[2]));
  const IntMask is_beside = hn::And(hn::Lt(some_negative, zero), hn::Gt(highest_edge, zero));
  const Int more = hn::BitCast(ints, hn::Sub(last, first));  // centres between, less one
  const IntMask has_one = hn::Eq(more, zero);
  const IntMask has_none = hn::Ne(hn::And(more, hn::Set(ints, static_cast<std::int32_t>(0x80008000u))), zero);
  return {hn::Or(has_none, hn::And(has_one, is_beside)), hn::Add(edges[0], hn::Add(edges[1], edges[2]))};
}

/// The triangles that are left out, by the signs of their areas.
struct EmptyCounts {
  std::size_t all = 0, positive = 0, negative = 0;
};

void add(const EmptyTrianglesWork& work, const EmptyCounts& empty, Counters& counters) {
  // y points down on the picture: a negative area is a positive determinant.
  const std::size_t culled =
      (work.cull_positive ? empty.negative : 0) + (work.cull_negative ? empty.positive : 0);
  counters.triangles += empty.all;
  counters.culled += culled;
  counters.trivially_accepted += empty.all - culled;
  counters.screen_triangles += empty.all - culled;
  counters.zero_area += empty.all - empty.positive - empty.negative;
  counters.back_facing += work.is_back_positive ? empty.negative : empty.positive;
}

/// Looks at the triangles from `first` on, as many as a vector has lanes.
HWY_INLINE Found look_at_triangles(const EmptyTrianglesWork& work, std::uint32_t first, IntMask present) {
  const std::uint16_t* const a = work.corners[0] + first;
  const std::uint16_t* const b = work.corners[1] + first;
  const std::uint16_t* const c = work.corners[2] + first;
  const std::uint16_t window = work.windows[first / window_triangles];
  if (HWY_LIKELY(window != no_window)) {
    const InWindow vertices(work.scratch, window);
    return look_at(vertices(a), vertices(b), vertices(c));
  }
  const auto vertices = [&](const std::uint16_t* corner) { return in_memory(work.scratch, corner, present); };
  return look_at(vertices(a), vertices(b), vertices(c));
}

/// Lists, in kept_triangles, the places of the triangles that are left. @return how many
HWY_INLINE std::uint32_t list_left(const EmptyTrianglesWork& work, Counters& counters) {
  const std::uint32_t count = work.triangle_count;
  auto* const places = reinterpret_cast<std::int32_t*>(work.kept_triangles);
  const Int end = hn::Set(ints, static_cast<std::int32_t>(count)), zero = hn::Zero(ints);
  const Int step = hn::Set(ints, static_cast<std::int32_t>(lanes()));
  // Counted on: an Iota with a variable is stored lane by lane.
  Int place = hn::Iota(ints, 0);
  EmptyCounts counts;
  std::size_t listed = 0;
  for (std::uint32_t i = 0; i < count;
       i += static_cast<std::uint32_t>(lanes()), place = hn::Add(place, step)) {
    const IntMask present = hn::Lt(place, end);
    const Found found = look_at_triangles(work, i, present);
    const IntMask left = hn::AndNot(found.is_empty, present);
    const IntMask empty = hn::And(present, found.is_empty);
    counts.positive += hn::CountTrue(ints, hn::And(empty, hn::Gt(found.area, zero)));
    counts.negative += hn::CountTrue(ints, hn::And(empty, hn::Lt(found.area, zero)));
    hn::StoreU(hn::Compress(place, left), ints, places + listed);
    listed += hn::CountTrue(ints, left);
  }
  counts.all = count - listed;
  add(work, counts, counters);
  return static_cast<std::uint32_t>(listed);
}

/// Copies the triangles whose places stand in kept_triangles.
HWY_INLINE void copy_listed(const EmptyTrianglesWork& work, std::uint32_t count) {
  std::uint32_t* out = work.kept_indices;
  for (std::uint32_t i = 0; i < count; ++i, out += 3) {
    const std::size_t from = work.kept_triangles[i];
    for (std::size_t v = 0; v < 3; ++v) out[v] = work.first_vertex + work.corners[v][from];
    work.kept_triangles[i] = work.triangles[from];
  }
}

std::uint32_t keep_all(const EmptyTrianglesWork& work) {
  for (std::size_t i = 0; i < 3 * static_cast<std::size_t>(work.triangle_count); ++i) {
    work.kept_indices[i] = work.indices[i];
  }
  for (std::size_t i = 0; i < work.triangle_count; ++i) work.kept_triangles[i] = work.triangles[i];
  return work.triangle_count;
}

}  // namespace

std::uint32_t leave_out_empty(const EmptyTrianglesWork& work, Counters& counters) {
  if (work.vertex_count > most_packed_vertices) return keep_all(work);
  if (!pack(work).is_narrow) return keep_all(work);
  const std::uint32_t left = list_left(work, counters);
  copy_listed(work, left);
  return left;
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace velum {

LeaveOutEmpty empty_triangles_kernel(Isa isa) {
  static constexpr auto versions = VELUM_KERNEL_VERSIONS(leave_out_empty);
  return versions.at(isa);
}

}  // namespace velum
#endif
