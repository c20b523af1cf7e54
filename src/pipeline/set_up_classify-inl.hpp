// Which triangles of a chunk become what; see set_up_simd.cpp.
#if defined(VELUM_SET_UP_CLASSIFY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_SET_UP_CLASSIFY_INL
#undef VELUM_SET_UP_CLASSIFY_INL
#else
#define VELUM_SET_UP_CLASSIFY_INL
#endif

#include "set_up_edges-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// Small triangles: where each is, as SmallTriangle has it.
struct SmallList {
  ChunkList list;
  HWY_ALIGN std::int32_t left_top[chunk_room];
  HWY_ALIGN std::int32_t right_bottom[chunk_room];
};

/// Triangles of a pixel or two that cover a centre.
struct TinyArrays {
  ChunkList list;
  HWY_ALIGN std::int32_t covered[chunk_room];  ///< bit x + 2·y: the centre at (left + x, top + y)
  HWY_ALIGN std::int32_t left[chunk_room];
  HWY_ALIGN std::int32_t top[chunk_room];
};

/// The smallest and largest pixels met so far, lane by lane.
struct BoxLanes {
  Int left, top, right, bottom;
};
HWY_INLINE BoxLanes no_box() {
  const Int most = hn::Set(ints, INT32_MAX), least = hn::Set(ints, INT32_MIN);
  return {most, most, least, least};
}

HWY_INLINE std::size_t append(Int values, IntMask which, std::int32_t* out) {
  hn::StoreU(hn::Compress(values, which), ints, out);
  return hn::CountTrue(ints, which);
}

HWY_INLINE void append_large(Int places, IntMask which, const TriangleLanes& t, LargeList& out) {
  const std::size_t at = out.list.count;
  for (int v = 0; v < 3; ++v) {
    append(t.x[v], which, out.x[v] + at);
    append(t.y[v], which, out.y[v] + at);
  }
  out.list.count += append(places, which, out.list.place + at);
}

HWY_INLINE void append_small(Int places, IntMask which, const CentreBox& box, SmallList& out) {
  const std::size_t at = out.list.count;
  append(packed_shorts(box.left, box.top), which, out.left_top + at);
  append(packed_shorts(box.right, box.bottom), which, out.right_bottom + at);
  out.list.count += append(places, which, out.list.place + at);
}

/// Which of the centres of boxes of at most tiny_size are covered, as TinyArrays::covered.
HWY_INLINE Int covered_centres(const EdgeLanes& edges, const CentreBox& box) {
  const Int zero = hn::Zero(ints);
  Int outside[4] = {zero, zero, zero, zero};  // negative: outside
  for (int i = 0; i < 3; ++i) {
    const Int right = hn::Add(edges.value[i], edges.step_x[i]);
    outside[0] = hn::Or(outside[0], edges.value[i]);
    outside[1] = hn::Or(outside[1], right);
    outside[2] = hn::Or(outside[2], hn::Add(edges.value[i], edges.step_y[i]));
    outside[3] = hn::Or(outside[3], hn::Add(right, edges.step_y[i]));
  }
  const Int is_narrow = hn::Sub(hn::Sub(box.right, box.left), hn::Set(ints, 1));  // -1: one column
  const Int is_low = hn::Sub(hn::Sub(box.bottom, box.top), hn::Set(ints, 1));
  outside[1] = hn::Or(outside[1], is_narrow);
  outside[2] = hn::Or(outside[2], is_low);
  outside[3] = hn::Or(outside[3], hn::Or(is_narrow, is_low));
  Int covered = zero;
  for (int i = 0; i < 4; ++i) {
    covered = hn::Or(covered, hn::IfThenZeroElse(hn::Lt(outside[i], zero), hn::Set(ints, 1 << i)));
  }
  return covered;
}

HWY_INLINE void append_tiny(Int places, IntMask which, const EdgeLanes& edges, const CentreBox& box,
                            TinyArrays& out) {
  const Int covered = covered_centres(edges, box);
  which = hn::And(which, hn::Gt(covered, hn::Zero(ints)));
  const std::size_t at = out.list.count;
  append(covered, which, out.covered + at);
  append(box.left, which, out.left + at);
  append(box.top, which, out.top + at);
  out.list.count += append(places, which, out.list.place + at);
}

HWY_INLINE void widen(BoxLanes& lanes, IntMask which, const CentreBox& box) {
  lanes.left = hn::IfThenElse(which, hn::Min(lanes.left, box.left), lanes.left);
  lanes.top = hn::IfThenElse(which, hn::Min(lanes.top, box.top), lanes.top);
  lanes.right = hn::IfThenElse(which, hn::Max(lanes.right, box.right), lanes.right);
  lanes.bottom = hn::IfThenElse(which, hn::Max(lanes.bottom, box.bottom), lanes.bottom);
}

HWY_INLINE PixelBox box_of(const BoxLanes& lanes) {
  return {hn::GetLane(hn::MinOfLanes(ints, lanes.left)), hn::GetLane(hn::MinOfLanes(ints, lanes.top)),
          hn::GetLane(hn::MaxOfLanes(ints, lanes.right)), hn::GetLane(hn::MaxOfLanes(ints, lanes.bottom))};
}

/// Facing by the snapped area, whose sign is the determinant's for small triangles: y points down on the
/// picture, so a negative area is a positive determinant. @return which are kept
HWY_INLINE IntMask count_facing(const SetUpWork& work, Int area, IntMask present, Counters& counters) {
  const IntMask positive = hn::And(present, hn::Lt(area, hn::Zero(ints)));
  const IntMask negative = hn::And(present, hn::Gt(area, hn::Zero(ints)));
  IntMask culled = hn::FirstN(ints, 0);
  if (work.cull_positive) culled = positive;
  if (work.cull_negative) culled = hn::Or(culled, negative);
  const std::size_t count = hn::CountTrue(ints, present);
  const std::size_t left_out = hn::CountTrue(ints, culled);
  counters.triangles += count;
  counters.culled += left_out;
  counters.trivially_accepted += count - left_out;
  counters.screen_triangles += count - left_out;
  counters.back_facing += hn::CountTrue(ints, work.is_back_positive ? positive : negative);
  return hn::AndNot(culled, present);
}

/// Whether each vertex has a place on the picture.
HWY_INLINE IntMask are_placed(const TriangleLanes& t) {
  return hn::Gt(lowest(t.x), hn::Set(ints, not_snapped));
}
static_assert(not_snapped == INT32_MIN);

/// Triangles wholly outside of one plane. @return which of those without a place are
HWY_INLINE IntMask count_rejected(const TriangleLanes& t, IntMask without_place, Counters& counters) {
  const Int nowhere = hn::Set(ints, not_snapped), all_planes = hn::Set(ints, 63);
  Int outside = all_planes;
  for (int v = 0; v < 3; ++v) outside = hn::And(outside, hn::IfThenElseZero(hn::Eq(t.x[v], nowhere), t.y[v]));
  const IntMask rejected = hn::And(without_place, hn::Gt(outside, hn::Zero(ints)));
  const std::size_t count = hn::CountTrue(ints, rejected);
  if (count == 0) return rejected;
  counters.triangles += count;
  counters.trivially_rejected += count;
  for (int i = 0; i < 6; ++i) {
    const IntMask outside_i = hn::TestBit(outside, hn::Set(ints, 1 << i));
    counters.outside[i] += hn::CountTrue(ints, hn::And(rejected, outside_i));
  }
  return rejected;
}

/// Sends every triangle of the chunk to one of the lists; small ones that cover nothing, and what is wholly
/// outside, to none.
HWY_INLINE void classify(const SetUpWork& work, const Chunk& chunk, ChunkList& slow, LargeList& large,
                         SmallList& small, TinyArrays& tiny, BoxLanes& box_lanes, Counters& counters) {
  const Int size = hn::Set(ints, tiny_size);
  for (std::size_t i = 0; i < chunk.count; i += hn::Lanes(ints)) {
    const TriangleLanes t = load_triangles(chunk.xy, i);
    // Not Iota(i), which stores lane by lane.
    const Int places = hn::Add(hn::Iota(ints, 0), hn::Set(ints, static_cast<std::int32_t>(i)));
    const IntMask fetched = hn::Lt(places, hn::Set(ints, static_cast<std::int32_t>(chunk.count)));
    const IntMask placed = are_placed(t);
    const IntMask without_place = hn::AndNot(placed, fetched);
    if (!hn::AllFalse(ints, without_place)) {
      const IntMask rejected = count_rejected(t, without_place, counters);
      slow.count += append(places, hn::AndNot(rejected, without_place), slow.place + slow.count);
    }
    const IntMask present = hn::And(fetched, placed);
    const AreaLanes area = area_of(t);
    const IntMask to_large = hn::AndNot(area.is_small, present);
    if (!hn::AllFalse(ints, to_large)) append_large(places, to_large, t, large);
    const IntMask kept = count_facing(work, area.area, hn::And(present, area.is_small), counters);
    const CentreBox box = centre_box(work, t);
    const IntMask is_empty = hn::Or(hn::Gt(box.left, box.right), hn::Gt(box.top, box.bottom));
    const IntMask in_target = hn::AndNot(is_empty, kept);
    if (hn::AllFalse(ints, in_target)) continue;
    widen(box_lanes, in_target, box);
    const IntMask is_tiny =
        hn::And(hn::Lt(hn::Sub(box.right, box.left), size), hn::Lt(hn::Sub(box.bottom, box.top), size));
    const IntMask to_tiny = hn::And(in_target, is_tiny), to_small = hn::AndNot(is_tiny, in_target);
    if (!hn::AllFalse(ints, to_tiny)) {
      append_tiny(places, to_tiny, edges_of(clockwise(t, area.area), box), box, tiny);
    }
    if (!hn::AllFalse(ints, to_small)) append_small(places, to_small, box, small);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
