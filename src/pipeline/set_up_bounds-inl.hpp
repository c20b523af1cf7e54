// Where small triangles are; see set_up_simd.cpp.
#if defined(VELUM_SET_UP_BOUNDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_SET_UP_BOUNDS_INL
#undef VELUM_SET_UP_BOUNDS_INL
#else
#define VELUM_SET_UP_BOUNDS_INL
#endif

#include "set_up_classify-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// The largest nearness of the three vertices of each listed triangle.
HWY_INLINE void find_nearest(const SetUpWork& work, const Chunk& chunk, const ChunkList& list, float* out) {
  for (std::size_t i = 0; i < list.count; ++i) {
    const std::uint32_t* const vertex =
        work.indices + 3 * static_cast<std::size_t>(chunk.triangle(list.place[i]));
    const float a = work.nearness[vertex[0]], b = work.nearness[vertex[1]], c = work.nearness[vertex[2]];
    const float ab = a < b ? b : a;
    out[i] = ab < c ? c : ab;
  }
}

/// Writes where the listed triangles are, how near, and which.
HWY_INLINE void write_bounds(const SetUpWork& work, const Chunk& chunk, const SmallList& s, std::size_t at) {
  HWY_ALIGN float nearest[chunk_room] = {};
  if (work.nearness != nullptr) find_nearest(work, chunk, s.list, nearest);
  const Int target = hn::Set(ints, work.target_left | work.target_top << 16);
  // Both halves at once: what moves from the upper into the lower is masked out.
  const Int no_stray = hn::Set(ints, 0x1FFF1FFF);
  const auto blocks = [&](const std::int32_t* pixels) {
    return hn::And(hn::ShiftRight<3>(hn::Sub(hn::Load(ints, pixels), target)), no_stray);
  };
  const Int first_ref = hn::Set(ints, static_cast<std::int32_t>(work.first_ref + chunk.first - work.first));
  for (std::size_t i = 0; i < s.list.count; i += hn::Lanes(ints)) {
    const Int nearest_bits = hn::Load(ints, reinterpret_cast<const std::int32_t*>(nearest + i));
    hn::StoreInterleaved3(blocks(s.left_top + i), blocks(s.right_bottom + i), nearest_bits, ints,
                          reinterpret_cast<std::int32_t*>(work.small_bounds + at + i));
    hn::StoreU(hn::Add(hn::Load(ints, s.list.place + i), first_ref), ints,
               reinterpret_cast<std::int32_t*>(work.small_refs + at + i));
  }
}
static_assert(block_size == 8 && offsetof(SmallBounds, nearest) == 8);

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
