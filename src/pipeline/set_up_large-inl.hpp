// Triangles that are not small, or that snapping may have turned over; see set_up_simd.cpp.
#if defined(VELUM_SET_UP_LARGE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_SET_UP_LARGE_INL
#undef VELUM_SET_UP_LARGE_INL
#else
#define VELUM_SET_UP_LARGE_INL
#endif

#include "set_up_chunk-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

struct SnappedLanes {
  Double x[3], y[3];
};

/// doubled_area(): exact, since coordinates have 24 bits.
HWY_INLINE Double doubled_area(const SnappedLanes& s) {
  return product_difference(hn::Sub(s.x[1], s.x[0]), hn::Sub(s.y[2], s.y[0]), hn::Sub(s.y[1], s.y[0]),
                            hn::Sub(s.x[2], s.x[0]));
}

/// Whether a pixel centre first + ½ … end - ½ lies between the smallest and largest coordinate.
struct CentreLanes {
  Double from, to;
};
HWY_INLINE CentreLanes centres_between(const Double (&v)[3], int first, int end) {
  const Double pixel = hn::Set(doubles, 1.0 / 256.0), half = hn::Set(doubles, 0.5);
  const Double lowest = hn::Mul(hn::Min(v[0], hn::Min(v[1], v[2])), pixel);
  const Double highest = hn::Mul(hn::Max(v[0], hn::Max(v[1], v[2])), pixel);
  return {hn::Max(hn::Ceil(hn::Sub(lowest, half)), hn::Set(doubles, first)),
          hn::Min(hn::Floor(hn::Sub(highest, half)), hn::Set(doubles, end - 1.0))};
}

HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(doubles, mask, bits);
  return bits[0];
}

/// Facing by the determinant, and what else is counted. @return which of the triangles are kept
HWY_INLINE std::uint32_t count_facing(const SetUpWork& work, Double determinant, Double area,
                                      std::uint32_t present, Counters& counters) {
  const Double zero = hn::Zero(doubles);
  const std::uint32_t positive = bits_of(hn::Gt(determinant, zero)) & present;
  const std::uint32_t negative = bits_of(hn::Lt(determinant, zero)) & present;
  const std::uint32_t edge_on = bits_of(hn::Eq(determinant, zero)) & present;
  const std::uint32_t neither = present & ~(positive | negative);  // edge-on, or too large for a number
  const std::uint32_t culled = (work.cull_positive ? positive : 0u) | (work.cull_negative ? negative : 0u) |
                               (work.cull_zero ? neither : 0u);
  const std::uint32_t kept = present & ~culled;
  const std::uint32_t clockwise = bits_of(hn::Gt(area, zero));
  const std::uint32_t with_area = bits_of(hn::Ne(area, zero));
  counters.triangles += hwy::PopCount(present);
  counters.edge_on += hwy::PopCount(edge_on);
  counters.back_facing += hwy::PopCount(work.is_back_positive ? positive : negative);
  counters.culled += hwy::PopCount(culled);
  counters.trivially_accepted += hwy::PopCount(kept);
  counters.screen_triangles += hwy::PopCount(kept);
  // y points down on the picture, so counter-clockwise triangles have a negative doubled area there.
  counters.reversed += hwy::PopCount(kept & with_area & ~(clockwise ^ (positive | edge_on)));
  counters.zero_area += hwy::PopCount(kept & ~with_area);
  return kept & with_area;
}

/// Writes triangle `number` of the list, turned clockwise. @param at  where its depth plane is
HWY_INLINE void write_large(const SetUpWork& work, const Chunk& chunk, const LargeList& large,
                            std::size_t number, const PlaneArrays& depth, std::size_t at, bool is_clockwise,
                            RasterTriangle& out) {
  const int order[3] = {0, is_clockwise ? 1 : 2, is_clockwise ? 2 : 1};
  for (int i = 0; i < 3; ++i) {
    out.x[i] = large.x[order[i]][number];
    out.y[i] = large.y[order[i]][number];
  }
  out.r_ref = depth.r_ref[at];
  out.dx = depth.dx[at];
  out.dy = depth.dy[at];
  out.x_ref = depth.x_ref[at];
  out.y_ref = depth.y_ref[at];
  out.lower = depth.lower[at];
  out.upper = depth.upper[at];
  out.primitive = primitive_of(work, chunk.triangle(large.list.place[number]));
}

/// As many triangles of the list as a vector has lanes, beginning with `first`.
HWY_INLINE void set_up_large_lanes(const SetUpWork& work, const Chunk& chunk, const LargeList& large,
                                   const FetchedVertices& vertices, std::size_t first, PlaneArrays& depth,
                                   SetUpResult& result, Counters& counters) {
  const std::size_t count = HWY_MIN(large.list.count - first, hn::Lanes(doubles));
  SnappedLanes s;
  for (int v = 0; v < 3; ++v) {
    s.x[v] = hn::PromoteTo(doubles, hn::LoadU(narrow_ints, large.x[v] + first));
    s.y[v] = hn::PromoteTo(doubles, hn::LoadU(narrow_ints, large.y[v] + first));
  }
  const Vertex v[3] = {vertices.load(work, 0, first), vertices.load(work, 1, first),
                       vertices.load(work, 2, first)};
  const Plane plane = plane_of(v[0], v[1], v[2]);
  const Double area = doubled_area(s);
  const std::uint32_t kept = count_facing(work, plane.determinant, area, (1u << count) - 1u, counters);
  const CentreLanes x = centres_between(s.x, work.target_left, work.target_right);
  const CentreLanes y = centres_between(s.y, work.target_top, work.target_bottom);
  std::uint32_t left = kept & bits_of(hn::And(hn::Le(x.from, x.to), hn::Le(y.from, y.to)));
  if (left == 0) return;
  set_up_depth(work, v, plane, 0, depth);
  const std::uint32_t clockwise = bits_of(hn::Gt(area, hn::Zero(doubles)));
  HWY_ALIGN double box[4][8];
  hn::Store(x.from, doubles, box[0]), hn::Store(y.from, doubles, box[1]);
  hn::Store(x.to, doubles, box[2]), hn::Store(y.to, doubles, box[3]);
  for (; left != 0; left &= left - 1) {
    const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    write_large(work, chunk, large, first + i, depth, i, ((clockwise >> i) & 1u) != 0,
                work.large[result.large++]);
    result.box = united(result.box, {static_cast<int>(box[0][i]), static_cast<int>(box[1][i]),
                                     static_cast<int>(box[2][i]), static_cast<int>(box[3][i])});
  }
}

HWY_INLINE void set_up_large(const SetUpWork& work, const Chunk& chunk, const LargeList& large,
                             FetchedVertices& vertices, PlaneArrays& depth, SetUpResult& result,
                             Counters& counters) {
  fetch_vertices(work, chunk, large.list, vertices);
  for (std::size_t i = 0; i < large.list.count; i += hn::Lanes(doubles)) {
    set_up_large_lanes(work, chunk, large, vertices, i, depth, result, counters);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
