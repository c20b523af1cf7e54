// Triangles fetched for the set-up; see set_up_simd.cpp.
#if defined(VELUM_SET_UP_CHUNK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_SET_UP_CHUNK_INL
#undef VELUM_SET_UP_CHUNK_INL
#else
#define VELUM_SET_UP_CHUNK_INL
#endif

#include <hwy/cache_control.h>

#include "set_up_depth-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

using Ints = hn::CappedTag<std::int32_t, 16>;
using Int = hn::Vec<Ints>;
using IntMask = hn::Mask<Ints>;
constexpr Ints ints;

/// Triangles whose vertices all have a place on the picture: coordinate after coordinate.
struct Chunk {
  HWY_ALIGN std::int32_t x[3][chunk_room];
  HWY_ALIGN std::int32_t y[3][chunk_room];
  std::uint32_t triangle[chunk_room];
  std::size_t count;
};

/// Some of a chunk's triangles, by their places in it.
struct ChunkList {
  HWY_ALIGN std::int32_t place[chunk_room];
  std::size_t count = 0;
};

/// Vertices stand anywhere in memory: those of as many triangles on are asked for beforehand.
constexpr std::uint32_t fetch_ahead = 24;

/// Fetches triangles, beginning with `next`, until the chunk is full; the numbers of those with a vertex that
/// has no place go to work.slow.
HWY_INLINE void fetch(const SetUpWork& work, std::uint32_t& next, Chunk& out, std::size_t& slow) {
  std::size_t count = 0;
  for (; next < work.last && count < chunk_size; ++next) {
    const std::uint32_t* const indices = work.indices + 3 * static_cast<std::size_t>(next);
    if (next + fetch_ahead < work.last) {
      for (std::uint32_t v = 0; v < 3; ++v) hwy::Prefetch(work.placed + indices[3 * fetch_ahead + v]);
    }
    const PlacedVertex a = work.placed[indices[0]];
    const PlacedVertex b = work.placed[indices[1]];
    const PlacedVertex c = work.placed[indices[2]];
    out.x[0][count] = a.x, out.x[1][count] = b.x, out.x[2][count] = c.x;
    out.y[0][count] = a.y, out.y[1][count] = b.y, out.y[2][count] = c.y;
    out.triangle[count] = next;
    const bool has_place = a.x != not_snapped && b.x != not_snapped && c.x != not_snapped;
    count += has_place;
    if (!has_place) work.slow[slow++] = next;
  }
  out.count = count;
}

/// Copies the vertices of the listed triangles.
HWY_INLINE void fetch_vertices(const SetUpWork& work, const Chunk& chunk, const ChunkList& list,
                               FetchedVertices& out) {
  for (std::size_t i = 0; i < list.count; ++i) {
    const std::size_t triangle = chunk.triangle[list.place[i]];
    for (std::size_t v = 0; v < 3; ++v) {
      const float* const position =
          work.positions + 3 * static_cast<std::size_t>(work.indices[3 * triangle + v]);
      hwy::CopyBytes<8>(position, out.position[v] + 4 * i);
      hwy::CopyBytes<4>(position + 2, out.position[v] + 4 * i + 2);
    }
  }
}

/// The ids of the listed triangles.
HWY_INLINE std::uint32_t primitive_of(const SetUpWork& work, std::uint32_t triangle) {
  return work.first_primitive + (work.primitives != nullptr ? work.primitives[triangle] : triangle);
}

HWY_INLINE std::uint32_t bits_of(hn::Mask<Ints> mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(ints, mask, bits);
  return bits[0] | (static_cast<std::uint32_t>(bits[1]) << 8);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
