// Small triangles, decided in integers; see set_up_simd.cpp.
#if defined(VELUM_SET_UP_SMALL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_SET_UP_SMALL_INL
#undef VELUM_SET_UP_SMALL_INL
#else
#define VELUM_SET_UP_SMALL_INL
#endif

#include "../visibility/screen_primitives.hpp"
#include "set_up_chunk-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// Small triangles on their way to SmallTriangle: its words, in its order.
struct SmallArrays {
  ChunkList list;
  HWY_ALIGN std::int32_t edge[3][chunk_room];
  HWY_ALIGN std::int32_t step[3][chunk_room];  ///< the six steps, two to a word
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

/// Pixels whose centres lie in the triangles' boxes and in the target, ends included.
struct CentreBox {
  Int left, top, right, bottom;
};

HWY_INLINE Int lowest(const Int (&v)[3]) {
  return hn::Min(v[0], hn::Min(v[1], v[2]));
}
HWY_INLINE Int highest(const Int (&v)[3]) {
  return hn::Max(v[0], hn::Max(v[1], v[2]));
}

HWY_INLINE CentreBox centre_box(const SetUpWork& work, const TriangleLanes& t) {
  const Int before = hn::Set(ints, 127), half = hn::Set(ints, 128);
  return {hn::Max(hn::ShiftRight<8>(hn::Add(lowest(t.x), before)), hn::Set(ints, work.target_left)),
          hn::Max(hn::ShiftRight<8>(hn::Add(lowest(t.y), before)), hn::Set(ints, work.target_top)),
          hn::Min(hn::ShiftRight<8>(hn::Sub(highest(t.x), half)), hn::Set(ints, work.target_right - 1)),
          hn::Min(hn::ShiftRight<8>(hn::Sub(highest(t.y), half)), hn::Set(ints, work.target_bottom - 1))};
}

/// doubled_area() where is_small() holds.
struct AreaLanes {
  Int area;
  IntMask is_small;
};
HWY_INLINE AreaLanes area_of(const TriangleLanes& t) {
  const Int x1 = hn::Sub(t.x[1], t.x[0]), x2 = hn::Sub(t.x[2], t.x[0]);
  const Int y1 = hn::Sub(t.y[1], t.y[0]), y2 = hn::Sub(t.y[2], t.y[0]);
  const Int limit = hn::Set(ints, small_extent);
  const IntMask is_short = hn::And(hn::Lt(hn::Sub(highest(t.x), lowest(t.x)), limit),
                                   hn::Lt(hn::Sub(highest(t.y), lowest(t.y)), limit));
  const Int area = hn::Sub(hn::Mul(x1, y2), hn::Mul(y1, x2));
  const Int turn = hn::Add(hn::Add(hn::Abs(x1), hn::Abs(y1)), hn::Add(hn::Abs(x2), hn::Abs(y2)));
  const IntMask is_sure = hn::Gt(hn::Abs(area), hn::Add(turn, hn::Set(ints, turned_margin)));
  return {area, hn::And(is_short, is_sure)};
}

/// The edge functions of SmallTriangle.
struct EdgeLanes {
  Int value[3], step_x[3], step_y[3];
};
HWY_INLINE EdgeLanes edges_of(const TriangleLanes& t, const CentreBox& box) {
  const Int half = hn::Set(ints, 128), zero = hn::Zero(ints);
  const Int centre_x = hn::Add(hn::ShiftLeft<8>(box.left), half);
  const Int centre_y = hn::Add(hn::ShiftLeft<8>(box.top), half);
  EdgeLanes edges;
  for (int from = 0; from < 3; ++from) {
    const int to = from == 2 ? 0 : from + 1;
    const Int dx = hn::Sub(t.x[to], t.x[from]), dy = hn::Sub(t.y[to], t.y[from]);
    const Int value =
        hn::Sub(hn::Mul(dx, hn::Sub(centre_y, t.y[from])), hn::Mul(dy, hn::Sub(centre_x, t.x[from])));
    const IntMask owns_its_points = hn::Or(hn::Lt(dy, zero), hn::And(hn::Eq(dy, zero), hn::Gt(dx, zero)));
    const Int less = hn::IfThenZeroElse(owns_its_points, hn::Set(ints, 1));
    edges.value[from] = hn::ShiftRight<8>(hn::Sub(value, less));
    edges.step_x[from] = hn::Neg(dy);
    edges.step_y[from] = dx;
  }
  return edges;
}

HWY_INLINE std::size_t append(Int values, IntMask which, std::int32_t* out) {
  hn::StoreU(hn::Compress(values, which), ints, out);
  return hn::CountTrue(ints, which);
}

HWY_INLINE Int packed_shorts(Int low, Int high) {
  return hn::Or(hn::And(low, hn::Set(ints, 0xFFFF)), hn::ShiftLeft<16>(high));
}

HWY_INLINE void append_small(Int places, IntMask which, const EdgeLanes& edges, const CentreBox& box,
                             SmallArrays& out) {
  const std::size_t at = out.list.count;
  for (int i = 0; i < 3; ++i) append(edges.value[i], which, out.edge[i] + at);
  append(packed_shorts(edges.step_x[0], edges.step_x[1]), which, out.step[0] + at);
  append(packed_shorts(edges.step_x[2], edges.step_y[0]), which, out.step[1] + at);
  append(packed_shorts(edges.step_y[1], edges.step_y[2]), which, out.step[2] + at);
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

/// Turns the triangles clockwise.
HWY_INLINE TriangleLanes clockwise(const TriangleLanes& t, Int area) {
  const IntMask turned = hn::Lt(area, hn::Zero(ints));
  return {{t.x[0], hn::IfThenElse(turned, t.x[2], t.x[1]), hn::IfThenElse(turned, t.x[1], t.x[2])},
          {t.y[0], hn::IfThenElse(turned, t.y[2], t.y[1]), hn::IfThenElse(turned, t.y[1], t.y[2])}};
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
HWY_INLINE void classify(const SetUpWork& work, const Chunk& chunk, ChunkList& slow, ChunkList& large,
                         SmallArrays& small, TinyArrays& tiny, BoxLanes& box_lanes, Counters& counters) {
  const Int size = hn::Set(ints, tiny_size);
  for (std::size_t i = 0; i < chunk.count; i += hn::Lanes(ints)) {
    const TriangleLanes t = load_triangles(chunk, i);
    const Int places = hn::Iota(ints, static_cast<std::int32_t>(i));
    const IntMask fetched = hn::Lt(places, hn::Set(ints, static_cast<std::int32_t>(chunk.count)));
    const IntMask placed = are_placed(t);
    const IntMask without_place = hn::AndNot(placed, fetched);
    if (!hn::AllFalse(ints, without_place)) {
      const IntMask rejected = count_rejected(t, without_place, counters);
      slow.count += append(places, hn::AndNot(rejected, without_place), slow.place + slow.count);
    }
    const IntMask present = hn::And(fetched, placed);
    const AreaLanes area = area_of(t);
    large.count += append(places, hn::AndNot(area.is_small, present), large.place + large.count);
    const IntMask kept = count_facing(work, area.area, hn::And(present, area.is_small), counters);
    const CentreBox box = centre_box(work, t);
    const IntMask is_empty = hn::Or(hn::Gt(box.left, box.right), hn::Gt(box.top, box.bottom));
    const IntMask in_target = hn::AndNot(is_empty, kept);
    if (hn::AllFalse(ints, in_target)) continue;
    widen(box_lanes, in_target, box);
    const IntMask is_tiny =
        hn::And(hn::Lt(hn::Sub(box.right, box.left), size), hn::Lt(hn::Sub(box.bottom, box.top), size));
    const EdgeLanes edges = edges_of(clockwise(t, area.area), box);
    const IntMask to_tiny = hn::And(in_target, is_tiny), to_small = hn::AndNot(is_tiny, in_target);
    if (!hn::AllFalse(ints, to_tiny)) append_tiny(places, to_tiny, edges, box, tiny);
    if (!hn::AllFalse(ints, to_small)) append_small(places, to_small, edges, box, small);
  }
}

/// The words of SmallTriangle four at a time, triangle after triangle.
struct FourWords {
  HWY_ALIGN std::int32_t word[4 * chunk_room];

  HWY_INLINE void interleave(const std::int32_t* a, const std::int32_t* b, const std::int32_t* c,
                             const std::int32_t* d, std::size_t count) {
    for (std::size_t i = 0; i < count; i += hn::Lanes(ints)) {
      hn::StoreInterleaved4(hn::Load(ints, a + i), hn::Load(ints, b + i), hn::Load(ints, c + i),
                            hn::Load(ints, d + i), ints, word + 4 * i);
    }
  }
};

HWY_INLINE const std::int32_t* bits_of(const float* values) {
  return reinterpret_cast<const std::int32_t*>(values);
}

/// The reference pixels, x in the low 16 bits, y in the high ones.
HWY_INLINE void pack_references(const PlaneArrays& depth, std::size_t count, std::int32_t* out) {
  for (std::size_t i = 0; i < count; i += hn::Lanes(ints)) {
    hn::Store(packed_shorts(hn::Load(ints, depth.x_ref + i), hn::Load(ints, depth.y_ref + i)), ints, out + i);
  }
}

/// Writes the listed triangles, which are words in arrays until then.
HWY_INLINE void write_small(const SetUpWork& work, const Chunk& chunk, const SmallArrays& s,
                            const PlaneArrays& depth, SmallTriangle* out) {
  HWY_ALIGN std::int32_t primitives[chunk_room];
  HWY_ALIGN std::int32_t references[chunk_room];
  find_primitives(work, chunk, s.list, primitives);
  pack_references(depth, s.list.count, references);
  FourWords words[4];
  words[0].interleave(s.edge[0], s.edge[1], s.edge[2], s.step[0], s.list.count);
  words[1].interleave(s.step[1], s.step[2], s.left_top, s.right_bottom, s.list.count);
  words[2].interleave(bits_of(depth.r_ref), bits_of(depth.dx), bits_of(depth.dy), bits_of(depth.lower),
                      s.list.count);
  words[3].interleave(bits_of(depth.upper), references, primitives, primitives, s.list.count);
  for (std::size_t i = 0; i < s.list.count; ++i) {
    auto* const bytes = reinterpret_cast<std::uint8_t*>(out + i);
    for (std::size_t k = 0; k < 4; ++k) hwy::CopyBytes<16>(words[k].word + 4 * i, bytes + 16 * k);
  }
}
/// Writes where the listed triangles are and how near.
HWY_INLINE void write_bounds(const SetUpWork& work, const SmallArrays& s, const PlaneArrays& depth,
                             SmallBounds* out) {
  const Int target = hn::Set(ints, work.target_left | work.target_top << 16);
  // Both halves at once: what moves from the upper into the lower is masked out.
  const Int no_stray = hn::Set(ints, 0x1FFF1FFF);
  const auto blocks = [&](const std::int32_t* pixels) {
    return hn::And(hn::ShiftRight<3>(hn::Sub(hn::Load(ints, pixels), target)), no_stray);
  };
  for (std::size_t i = 0; i < s.list.count; i += hn::Lanes(ints)) {
    hn::StoreInterleaved3(blocks(s.left_top + i), blocks(s.right_bottom + i),
                          hn::Load(ints, bits_of(depth.upper + i)), ints,
                          reinterpret_cast<std::int32_t*>(out + i));
  }
}
static_assert(block_size == 8 && offsetof(SmallBounds, nearest) == 8);

static_assert(offsetof(SmallTriangle, step_x) == 12 && offsetof(SmallTriangle, step_y) == 18 &&
              offsetof(SmallTriangle, left) == 24 && offsetof(SmallTriangle, r_ref) == 32 &&
              offsetof(SmallTriangle, upper) == 48 && offsetof(SmallTriangle, x_ref) == 52 &&
              offsetof(SmallTriangle, primitive) == 56);

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
