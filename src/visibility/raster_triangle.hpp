#pragma once

#include <cstddef>
#include <cstdint>

namespace velum {

/// What the vector z-buffer draws: plain numbers, no more than a cache line each. is_small() tells
/// which of the three a screen triangle becomes.

/// A ScreenTriangle of any size.
struct alignas(64) RasterTriangle {
  std::int32_t x[3];  ///< 1/256 pixel; clockwise as seen on the picture, with area
  std::int32_t y[3];
  float r_ref;  ///< the DepthPlane, field by field
  float dx;
  float dy;
  std::int32_t x_ref;
  std::int32_t y_ref;
  float lower;
  float upper;
  std::uint32_t primitive;
};

/// A triangle of less than small_extent on either axis, set up: everything about its edges fits 32 bits.
struct alignas(64) SmallTriangle {
  /// The three edge functions at the centre of pixel (left, top), in 1/256 of EdgeFunction's unit. All values
  /// at centres differ by multiples of 256, so rounding down keeps every sign.
  std::int32_t edge[3];
  std::int16_t step_x[3];                 ///< what they grow by per pixel to the right
  std::int16_t step_y[3];                 ///< and per pixel downwards
  std::int16_t left, top, right, bottom;  ///< pixels whose centres lie in its box, ends included, in the
                                          ///< target
  float r_ref;                            ///< the DepthPlane, field by field
  float dx;
  float dy;
  float lower;
  float upper;
  std::int16_t x_ref;
  std::int16_t y_ref;
  std::uint32_t primitive;
};
static_assert(sizeof(RasterTriangle) == 64 && sizeof(SmallTriangle) == 64);

/// Where a small triangle is, and how near: what sorting it into tiles needs.
struct SmallBounds {
  /// The blocks (see tile_buffer.hpp) that its box meets, counted from the target's first pixel, ends
  /// included.
  std::uint16_t left, top, right, bottom;
  float nearest;  ///< SmallTriangle::upper
};
static_assert(sizeof(SmallBounds) == 12);

/// Set in the number of a small triangle that is set up: the rest is its place among those. Any other is set
/// up by a SmallSource, and the number tells which and by which number there.
inline constexpr std::uint32_t ready_small = 1u << 31;

/// What RasterFragment::place grows by from tile to tile.
inline constexpr std::uint32_t fragment_places = 1u << 13;

/// A pixel centre that a triangle of a pixel or two covers.
struct RasterFragment {
  std::uint32_t place;      ///< tile · fragment_places + tile_place()
  std::int32_t depth;       ///< bits of the reversed depth
  std::uint32_t primitive;  ///< its id
};

/// The same field by field, as kernels write them.
template <typename Word, typename SignedWord>
struct FragmentFields {
  Word* place;
  SignedWord* depth;
  Word* primitive;
};
using FragmentArrays = FragmentFields<std::uint32_t, std::int32_t>;
using ConstFragmentArrays = FragmentFields<const std::uint32_t, const std::int32_t>;

/// A triangle whose coordinates are this far apart, 1/256 pixel, is not small.
inline constexpr std::int32_t small_extent = 32 * 256;
/// Added to the bound of what snapping does to the area, see is_small().
inline constexpr std::int32_t turned_margin = 16;
/// A small triangle whose box holds at most this many centres on either axis becomes fragments at once.
inline constexpr int tiny_size = 2;
/// Kernels write bounds by whole vectors: room for as many more.
inline constexpr std::size_t bounds_room = 16;
/// Room for the fragments of as many triangles: kernels write them by whole vectors.
constexpr std::size_t fragments_room(std::size_t triangles) {
  return triangles * tiny_size * tiny_size + 16;
}

}  // namespace velum
