// Triangles of a pixel or two become fragments; see set_up_simd.cpp.
#if defined(VELUM_SET_UP_TINY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_SET_UP_TINY_INL
#undef VELUM_SET_UP_TINY_INL
#else
#define VELUM_SET_UP_TINY_INL
#endif

#include "set_up_classify-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

using Floats = hn::RebindToFloat<Ints>;
using Float = hn::Vec<Floats>;
constexpr Floats floats;

/// RasterFragment::place of pixels of the picture.
HWY_INLINE Int places_of(const SetUpWork& work, Int x, Int y) {
  const Int column = hn::Sub(x, hn::Set(ints, work.target_left));
  const Int row = hn::Sub(y, hn::Set(ints, work.target_top));
  const Int tile =
      hn::Add(hn::Mul(hn::ShiftRight<6>(row), hn::Set(ints, work.tile_columns)), hn::ShiftRight<6>(column));
  const Int in_column =
      hn::Add(hn::ShiftLeft<3>(hn::And(row, hn::Set(ints, 63))), hn::And(column, hn::Set(ints, 7)));
  const Int eights = hn::And(column, hn::Set(ints, 56));
  const Int pixel = hn::Add(hn::Add(hn::ShiftLeft<6>(eights), hn::ShiftLeft<1>(eights)), in_column);
  return hn::Add(hn::ShiftLeft<13>(tile), pixel);
}
static_assert(tile_size == 64 && block_size == 8 && column_room == 8 * (64 + 2) &&
              fragment_places == 1 << 13);

/// The terms of DepthPlane::at that differ between the centres of a tiny triangle.
struct TinyDepth {
  Float columns[2], rows[2], lower, upper;
};
HWY_INLINE TinyDepth tiny_depth(const PlaneArrays& depth, std::size_t i, Int left, Int top) {
  const Float r_ref = hn::Load(floats, depth.r_ref + i);
  const Float dx = hn::Load(floats, depth.dx + i), dy = hn::Load(floats, depth.dy + i);
  const Int x = hn::Sub(left, hn::Load(ints, depth.x_ref + i));
  const Int y = hn::Sub(top, hn::Load(ints, depth.y_ref + i));
  const Int one = hn::Set(ints, 1);
  return {{hn::Add(r_ref, hn::Mul(dx, hn::ConvertTo(floats, x))),
           hn::Add(r_ref, hn::Mul(dx, hn::ConvertTo(floats, hn::Add(x, one))))},
          {hn::Mul(dy, hn::ConvertTo(floats, y)), hn::Mul(dy, hn::ConvertTo(floats, hn::Add(y, one)))},
          hn::Load(floats, depth.lower + i),
          hn::Load(floats, depth.upper + i)};
}

/// Writes the covered centres of the listed triangles, vector by vector. @param first  before them
HWY_INLINE std::size_t write_fragments(const SetUpWork& work, const Chunk& chunk, const TinyArrays& tiny,
                                       const PlaneArrays& depth, std::size_t first) {
  HWY_ALIGN std::int32_t primitives[chunk_room];
  find_primitives(work, chunk, tiny.list, primitives);
  std::size_t next = first;
  for (std::size_t i = 0; i < tiny.list.count; i += hn::Lanes(ints)) {
    const Int left = hn::Load(ints, tiny.left + i), top = hn::Load(ints, tiny.top + i);
    const Int covered = hn::Load(ints, tiny.covered + i);
    const Int id = hn::Load(ints, primitives + i);
    const IntMask present = hn::FirstN(ints, tiny.list.count - i);
    const TinyDepth d = tiny_depth(depth, i, left, top);
    for (int k = 0; k < 4; ++k) {
      const IntMask which = hn::And(present, hn::TestBit(covered, hn::Set(ints, 1 << k)));
      const Int place =
          places_of(work, hn::Add(left, hn::Set(ints, k & 1)), hn::Add(top, hn::Set(ints, k >> 1)));
      const Float r = hn::Min(hn::Max(hn::Add(d.columns[k & 1], d.rows[k >> 1]), d.lower), d.upper);
      append(place, which, reinterpret_cast<std::int32_t*>(work.fragments.place + next));
      append(hn::BitCast(ints, r), which, work.fragments.depth + next);
      next += append(id, which, reinterpret_cast<std::int32_t*>(work.fragments.primitive + next));
    }
  }
  return next - first;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
