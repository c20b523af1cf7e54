#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "../base/kept_array.hpp"
#include "raster_triangle.hpp"
#include "screen_triangle.hpp"
#include "tile_grid.hpp"

namespace velum {

/// Whether a screen triangle becomes a SmallTriangle (or fragments): its extent is less than small_extent,
/// and its area so large that snapping cannot have turned it over. Snapping moves each corner by half a unit
/// on either axis, which changes the doubled area by no more than the sum of |x| and |y| of both edges from
/// the first corner, and 2; the rest of the margin is for what rounds in double on the way.
/// @param area  doubled_area(v)
bool is_small(const std::array<SnappedVertex, 3>& v, std::int64_t area);
inline constexpr std::int32_t turned_margin = 16;

/// Fragments, field by field.
class KeptFragments {
 public:
  /// Makes room for at least `count`; the first `kept` keep their values.
  void make_room(std::size_t count, std::size_t kept) {
    place_.make_room(count, kept);
    depth_.make_room(count, kept);
    primitive_.make_room(count, kept);
  }
  /// Those from number i on.
  FragmentArrays from(std::size_t i) { return {place_.data() + i, depth_.data() + i, primitive_.data() + i}; }
  ConstFragmentArrays all() const { return {place_.data(), depth_.data(), primitive_.data()}; }

 private:
  KeptArray<std::uint32_t> place_;
  KeptArray<std::int32_t> depth_;
  KeptArray<std::uint32_t> primitive_;
};

/// Triangles and fragments that wait to be sorted into tiles, each kind in the order of its triangles. Kinds
/// have their own arrays; the memory is kept.
struct ScreenPrimitives {
  KeptArray<RasterTriangle> large;
  KeptArray<SmallTriangle> small;
  KeptArray<SmallBounds> small_bounds;  ///< of `small`
  KeptFragments fragments;
  std::size_t large_count = 0;
  std::size_t small_count = 0;
  std::size_t fragment_count = 0;
  PixelBox box;  ///< around all of them

  void clear();
  /// That are in use.
  std::uint64_t bytes() const;
  /// Makes room for as many triangles more.
  void make_room(std::size_t triangles);
};

/// The pixels of the target whose centres lie in the box around three vertices.
/// @param x, y  their coordinates, 1/256 pixel
PixelBox centres_in_box(const std::int32_t (&x)[3], const std::int32_t (&y)[3], const Rect& target);

/// Appends the triangle as what it becomes, if a pixel centre of the grid's target lies in its box.
/// @return false if it has no area on the pixel grid
bool append_triangle(const ScreenTriangle& triangle, const TileGrid& grid, ScreenPrimitives& out);

}  // namespace velum
