// Small triangles, decided in integers; see set_up_simd.cpp.
#if defined(VELUM_SET_UP_SMALL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VELUM_SET_UP_SMALL_INL
#undef VELUM_SET_UP_SMALL_INL
#else
#define VELUM_SET_UP_SMALL_INL
#endif

#include "set_up_edges-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace velum {
namespace HWY_NAMESPACE {
namespace {

/// Small triangles on their way to SmallTriangle: its words, in its order.
struct SmallArrays {
  HWY_ALIGN std::int32_t edge[3][chunk_room];
  HWY_ALIGN std::int32_t step[3][chunk_room];  ///< the six steps, two to a word
  HWY_ALIGN std::int32_t left_top[chunk_room];
  HWY_ALIGN std::int32_t right_bottom[chunk_room];
};

/// What the passes over a few triangles hand on.
struct SmallPasses {
  HWY_ALIGN std::int32_t xy[3][2 * chunk_room];  ///< as in Chunk
  FetchedVertices vertices;
  SmallArrays arrays;
  PlaneArrays depth;
};

HWY_INLINE void set_up_edges(const SetUpWork& work, std::size_t count, SmallPasses& p) {
  SmallArrays& out = p.arrays;
  for (std::size_t i = 0; i < count; i += hn::Lanes(ints)) {
    const TriangleLanes t = load_triangles(p.xy, i);
    const CentreBox box = centre_box(work, t);
    const EdgeLanes edges = edges_of(clockwise(t, area_of(t).area), box);
    for (int k = 0; k < 3; ++k) hn::Store(edges.value[k], ints, out.edge[k] + i);
    hn::Store(packed_shorts(edges.step_x[0], edges.step_x[1]), ints, out.step[0] + i);
    hn::Store(packed_shorts(edges.step_x[2], edges.step_y[0]), ints, out.step[1] + i);
    hn::Store(packed_shorts(edges.step_y[1], edges.step_y[2]), ints, out.step[2] + i);
    hn::Store(packed_shorts(box.left, box.top), ints, out.left_top + i);
    hn::Store(packed_shorts(box.right, box.bottom), ints, out.right_bottom + i);
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

/// Writes triangles that are words in arrays until then. @param triangles  their numbers
HWY_INLINE void write_small(const SetUpWork& work, const std::uint32_t* triangles, std::size_t count,
                            const SmallArrays& s, const PlaneArrays& depth, SmallTriangle* out) {
  HWY_ALIGN std::int32_t primitives[chunk_room];
  HWY_ALIGN std::int32_t references[chunk_room];
  for (std::size_t i = 0; i < count; ++i) {
    primitives[i] = static_cast<std::int32_t>(primitive_of(work, triangles[i]));
  }
  pack_references(depth, count, references);
  FourWords words[4];
  words[0].interleave(s.edge[0], s.edge[1], s.edge[2], s.step[0], count);
  words[1].interleave(s.step[1], s.step[2], s.left_top, s.right_bottom, count);
  words[2].interleave(bits_of(depth.r_ref), bits_of(depth.dx), bits_of(depth.dy), bits_of(depth.lower),
                      count);
  words[3].interleave(bits_of(depth.upper), references, primitives, primitives, count);
  for (std::size_t i = 0; i < count; ++i) {
    auto* const bytes = reinterpret_cast<std::uint8_t*>(out + i);
    for (std::size_t k = 0; k < 4; ++k) hwy::CopyBytes<16>(words[k].word + 4 * i, bytes + 16 * k);
  }
}

/// Sets up small triangles, at most chunk_size of them. @param triangles  their numbers
HWY_INLINE void set_up_few(const SetUpWork& work, const std::uint32_t* triangles, std::size_t count,
                           SmallPasses& p, SmallTriangle* out) {
  fetch_listed(work, triangles, count, p.xy, p.vertices);
  set_up_edges(work, count, p);
  set_up_depths(work, p.vertices, count, p.depth);
  write_small(work, triangles, count, p.arrays, p.depth, out);
}

static_assert(offsetof(SmallTriangle, step_x) == 12 && offsetof(SmallTriangle, step_y) == 18 &&
              offsetof(SmallTriangle, left) == 24 && offsetof(SmallTriangle, r_ref) == 32 &&
              offsetof(SmallTriangle, upper) == 48 && offsetof(SmallTriangle, x_ref) == 52 &&
              offsetof(SmallTriangle, primitive) == 56);

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace velum
HWY_AFTER_NAMESPACE();

#endif  // the guard that turns with the target
