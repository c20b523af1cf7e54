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

/// Neighbouring triangles.
struct Chunk {
  HWY_ALIGN std::int32_t xy[3][2 * chunk_room];  ///< the three vertices' coordinates, x and y in turn
  std::uint32_t first;                           ///< number of the first one
  std::size_t count;

  HWY_INLINE std::uint32_t triangle(std::int32_t place) const {
    return first + static_cast<std::uint32_t>(place);
  }
};

/// Triangles lane by lane.
struct TriangleLanes {
  Int x[3], y[3];
};
HWY_INLINE TriangleLanes load_triangles(const std::int32_t (&xy)[3][2 * chunk_room], std::size_t first) {
  TriangleLanes t;
  for (int v = 0; v < 3; ++v) hn::LoadInterleaved2(ints, xy[v] + 2 * first, t.x[v], t.y[v]);
  return t;
}

/// Some of a chunk's triangles, by their places in it.
struct ChunkList {
  HWY_ALIGN std::int32_t place[chunk_room];
  std::size_t count = 0;
};

/// Large triangles, by places and by coordinates, 1/256 pixel.
struct LargeList {
  ChunkList list;
  HWY_ALIGN std::int32_t x[3][chunk_room];
  HWY_ALIGN std::int32_t y[3][chunk_room];
};

/// Vertices of a mesh stand anywhere in memory: those of as many triangles on are asked for beforehand. Those
/// of a list that names its primitives are few, and have just been made.
constexpr std::uint32_t fetch_ahead = 24;

/// Fetches triangles, beginning with `first`, until the chunk is full.
HWY_INLINE void fetch(const SetUpWork& work, std::uint32_t first, Chunk& out) {
  out.first = first;
  out.count = HWY_MIN(chunk_size, work.last - first);
  const std::uint32_t* indices = work.indices + 3 * static_cast<std::size_t>(first);
  const std::size_t left = work.last - first;
  const bool is_whole_mesh = work.primitives == nullptr;
  const std::size_t with_more =
      is_whole_mesh && left > fetch_ahead ? HWY_MIN(out.count, left - fetch_ahead) : 0;
  for (std::size_t i = 0; i < out.count; ++i, indices += 3) {
    if (i < with_more) {
      for (std::uint32_t v = 0; v < 3; ++v) {
        const std::size_t vertex = indices[3 * fetch_ahead + v];
        hwy::Prefetch(work.placed + vertex);
        hwy::Prefetch(work.positions + 3 * vertex);
      }
    }
    for (std::uint32_t v = 0; v < 3; ++v) {
      hwy::CopyBytes<sizeof(PlacedVertex)>(work.placed + indices[v], out.xy[v] + 2 * i);
    }
  }
}

HWY_INLINE void copy_position(const SetUpWork& work, std::size_t vertex, float* out) {
  const float* const position = work.positions + 3 * vertex;
  hwy::CopyBytes<8>(position, out);
  hwy::CopyBytes<4>(position + 2, out + 2);
}

/// Copies the vertices of the listed triangles.
HWY_INLINE void fetch_vertices(const SetUpWork& work, const Chunk& chunk, const ChunkList& list,
                               FetchedVertices& out) {
  for (std::size_t i = 0; i < list.count; ++i) {
    const auto triangle = static_cast<std::size_t>(chunk.triangle(list.place[i]));
    for (std::size_t v = 0; v < 3; ++v) {
      copy_position(work, work.indices[3 * triangle + v], out.position[v] + 4 * i);
    }
  }
}

/// Fetches the triangles of the given numbers and what follows them to the end of a vector, which repeats the
/// last: it is computed, never used. @pre 0 < count ≤ chunk_size
HWY_INLINE void fetch_listed(const SetUpWork& work, const std::uint32_t* triangles, std::size_t count,
                             std::int32_t (&xy)[3][2 * chunk_room], FetchedVertices& out) {
  const std::size_t end = (count + hn::Lanes(ints) - 1) / hn::Lanes(ints) * hn::Lanes(ints);
  for (std::size_t i = 0; i < end; ++i) {
    const auto triangle = static_cast<std::size_t>(triangles[HWY_MIN(i, count - 1)]);
    for (std::size_t v = 0; v < 3; ++v) {
      const auto vertex = static_cast<std::size_t>(work.indices[3 * triangle + v]);
      hwy::CopyBytes<sizeof(PlacedVertex)>(work.placed + vertex, xy[v] + 2 * i);
      copy_position(work, vertex, out.position[v] + 4 * i);
    }
  }
}

/// The id of a triangle.
HWY_INLINE std::uint32_t primitive_of(const SetUpWork& work, std::uint32_t triangle) {
  return work.first_primitive + (work.primitives != nullptr ? work.primitives[triangle] : triangle);
}

/// The ids of the listed triangles.
HWY_INLINE void find_primitives(const SetUpWork& work, const Chunk& chunk, const ChunkList& list,
                                std::int32_t* out) {
  for (std::size_t i = 0; i < list.count; ++i) {
    out[i] = static_cast<std::int32_t>(primitive_of(work, chunk.triangle(list.place[i])));
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
