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

/// The vertices' window; see window_of().
HWY_INLINE PlacedWindow find_window(const PlacedVertex* placed, std::uint32_t count) {
  const auto* const words = reinterpret_cast<const std::int32_t*>(placed);
  Int left = hn::Set(ints, INT32_MAX), top = left, right = hn::Set(ints, INT32_MIN), bottom = right;
  std::size_t i = 0;
  for (; i + lanes() <= count; i += lanes()) {
    Int x, y;
    hn::LoadInterleaved2(ints, words + 2 * i, x, y);
    left = hn::Min(left, x);
    right = hn::Max(right, x);
    top = hn::Min(top, y);
    bottom = hn::Max(bottom, y);
  }
  PlacedBox box{hn::GetLane(hn::MinOfLanes(ints, left)), hn::GetLane(hn::MinOfLanes(ints, top)),
                hn::GetLane(hn::MaxOfLanes(ints, right)), hn::GetLane(hn::MaxOfLanes(ints, bottom))};
  for (; i < count; ++i) box.include(placed[i]);
  return window_around(box);
}

/// Brings the vertices into the window: y in the upper, x in the lower half of a word.
HWY_INLINE void pack(const EmptyTrianglesWork& work, const PlacedWindow& window) {
  const PlacedVertex* const placed = work.placed + work.first_vertex;
  const Int left = hn::Set(ints, window.left), top = hn::Set(ints, window.top);
  std::size_t i = 0;
  for (; i + lanes() <= work.vertex_count; i += lanes()) {
    Int x, y;
    hn::LoadInterleaved2(ints, reinterpret_cast<const std::int32_t*>(placed + i), x, y);
    hn::StoreU(hn::Or(hn::Sub(x, left), hn::ShiftLeft<16>(hn::Sub(y, top))), ints, work.scratch + i);
  }
  for (; i < work.vertex_count; ++i) {
    work.scratch[i] = (placed[i].x - window.left) | ((placed[i].y - window.top) * 65536);
  }
}

/// Looks vertices up one by one.
class InMemory {
 public:
  explicit InMemory(const std::int32_t* packed) : packed_(packed) {}
  HWY_INLINE Int operator()(const std::uint16_t* corners) const {
    return hn::GatherIndex(ints, packed_, hn::PromoteTo(ints, hn::LoadU(indices, corners)));
  }

 private:
  const std::int32_t* packed_;
};

/// Holds few vertices in `count` vectors and looks them up by the lane.
template <std::size_t count>
class InVectors {
 public:
  explicit HWY_INLINE InVectors(const std::int32_t* packed) {
    for (std::size_t i = 0; i < count; ++i) part_[i] = hn::LoadU(ints, packed + i * lanes());
  }
  HWY_INLINE Int operator()(const std::uint16_t* corners) const {
    const Int index = hn::PromoteTo(ints, hn::LoadU(indices, corners));
    const Int lane = hn::And(index, hn::Set(ints, static_cast<std::int32_t>(lanes() - 1)));
    return among<0, count>(index, hn::IndicesFromVec(ints, lane));
  }

 private:
  template <std::size_t first, std::size_t size, typename Lanes>
  HWY_INLINE Int among(Int index, Lanes lane) const {
    if constexpr (size == 1) {
      return hn::TableLookupLanes(part_[first], lane);
    } else {
      constexpr std::size_t half = size > 4 ? 4 : (size > 2 ? 2 : 1);
      const Int bit = hn::Set(ints, static_cast<std::int32_t>(half * lanes()));
      return hn::IfThenElse(hn::TestBit(index, bit), among<first + half, size - half>(index, lane),
                            among<first, half>(index, lane));
    }
  }

  Int part_[count];
};

/// One coordinate of triangles, lane by lane.
struct Coordinate {
  Int a, b, c;
};

/// Brings the coordinates to the centre of the first pixel that has its centre beyond the smallest.
/// @return pixels with centres between the smallest and the largest, less one
HWY_INLINE Int to_centre(Coordinate& v) {
  const Int half = hn::Set(ints, 128);
  const Int lowest = hn::Min(v.a, hn::Min(v.b, v.c)), highest = hn::Max(v.a, hn::Max(v.b, v.c));
  const Int first = hn::ShiftRight<8>(hn::Add(lowest, hn::Set(ints, 127)));
  const Int last = hn::ShiftRight<8>(hn::Sub(highest, half));
  const Int centre = hn::Add(hn::ShiftLeft<8>(first), half);
  v = {hn::Sub(v.a, centre), hn::Sub(v.b, centre), hn::Sub(v.c, centre)};
  return hn::Sub(last, first);
}

/// What is known of a vector of triangles.
struct Found {
  IntMask is_empty;  ///< covers no pixel centre, for sure
  Int area;          ///< doubled, of those that do not
};

HWY_INLINE Found look_at(Int a, Int b, Int c) {
  const auto low = [](Int v) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(v)); };
  const auto high = [](Int v) { return hn::ShiftRight<16>(v); };
  Coordinate x{low(a), low(b), low(c)}, y{high(a), high(b), high(c)};
  const Int columns = to_centre(x), rows = to_centre(y);
  const Int edges[3] = {hn::Sub(hn::Mul(x.a, y.b), hn::Mul(y.a, x.b)),
                        hn::Sub(hn::Mul(x.b, y.c), hn::Mul(y.b, x.c)),
                        hn::Sub(hn::Mul(x.c, y.a), hn::Mul(y.c, x.a))};
  // Signs: the centre lies left of one edge and right of another, and is the only one.
  const Int some_negative = hn::Or(edges[0], hn::Or(edges[1], edges[2]));
  const Int zero = hn::Zero(ints);
  const Int highest = hn::Max(edges[0], hn::Max(edges[1], edges[2]));
  const IntMask is_beside = hn::And(hn::Lt(some_negative, zero), hn::Gt(highest, zero));
  const IntMask has_one = hn::Eq(hn::Or(columns, rows), zero);
  const IntMask has_none = hn::Lt(hn::Or(columns, rows), zero);
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

/// Lists, in kept_triangles, the places of the triangles that are left. @return how many
template <typename Vertices>
HWY_INLINE std::uint32_t list_left(const EmptyTrianglesWork& work, const Vertices& vertices,
                                   Counters& counters) {
  const std::uint32_t count = work.triangle_count;
  auto* const places = reinterpret_cast<std::int32_t*>(work.kept_triangles);
  const std::uint16_t* const corners[3] = {work.corners[0], work.corners[1], work.corners[2]};
  const Int end = hn::Set(ints, static_cast<std::int32_t>(work.triangle_count)), zero = hn::Zero(ints);
  EmptyCounts counts;
  std::size_t listed = 0;
  for (std::uint32_t i = 0; i < count; i += static_cast<std::uint32_t>(lanes())) {
    const Found found = look_at(vertices(corners[0] + i), vertices(corners[1] + i), vertices(corners[2] + i));
    const Int place = hn::Iota(ints, static_cast<std::int32_t>(i));
    const IntMask present = hn::Lt(place, end);
    const IntMask left = hn::AndNot(found.is_empty, present);
    const IntMask empty = hn::And(present, found.is_empty);
    counts.all += hn::CountTrue(ints, empty);
    counts.positive += hn::CountTrue(ints, hn::And(empty, hn::Gt(found.area, zero)));
    counts.negative += hn::CountTrue(ints, hn::And(empty, hn::Lt(found.area, zero)));
    hn::StoreU(hn::Compress(place, left), ints, places + listed);
    listed += hn::CountTrue(ints, left);
  }
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
  const PlacedWindow window = find_window(work.placed + work.first_vertex, work.vertex_count);
  if (!window.is_narrow) return keep_all(work);
  pack(work, window);
  const std::size_t vectors = (work.vertex_count + lanes() - 1) / lanes();
  const std::uint32_t left = vectors <= 4   ? list_left(work, InVectors<4>(work.scratch), counters)
                             : vectors <= 6 ? list_left(work, InVectors<6>(work.scratch), counters)
                             : vectors <= 8 ? list_left(work, InVectors<8>(work.scratch), counters)
                                            : list_left(work, InMemory(work.scratch), counters);
  copy_listed(work, left);
  return left;
}

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
