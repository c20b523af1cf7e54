#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../base/kept_array.hpp"
#include "raster_triangle.hpp"
#include "screen_triangle.hpp"
#include "tile_grid.hpp"
#include "tile_raster.hpp"

namespace velum {

/// Whether a screen triangle becomes a SmallTriangle (or fragments): its extent is less than small_extent,
/// and its area so large that snapping cannot have turned it over. Snapping moves each corner by half a unit
/// on either axis, which changes the doubled area by no more than the sum of |x| and |y| of both edges from
/// the first corner, and 2; the rest of turned_margin is for what rounds in double on the way.
/// @param area  doubled_area(v)
bool is_small(const std::array<SnappedVertex, 3>& v, std::int64_t area);

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
  KeptArray<SmallBounds> small_bounds;  ///< of all small triangles
  KeptArray<std::uint32_t> small_refs;  ///< their numbers, see ready_small
  KeptArray<SmallTriangle> small;       ///< those that are set up
  std::vector<SmallSource> sources;     ///< those that are not; in the order of their numbers
  KeptFragments fragments;
  std::size_t large_count = 0;
  std::size_t small_count = 0;  ///< of all small triangles
  std::size_t ready_count = 0;  ///< of those that are set up
  std::size_t fragment_count = 0;
  PixelBox box;  ///< around all of them

  void clear();
  /// That are in use.
  std::uint64_t bytes() const;
  /// Makes room for as many triangles more, but not for setting up small ones.
  void make_room(std::size_t triangles);
  /// The same for small ones that are set up.
  void make_room_for_ready(std::size_t triangles) { small.make_room(ready_count + triangles, ready_count); }
  /// The number that the next source begins with.
  std::uint32_t next_ref() const { return sources.empty() ? 0 : sources.back().end; }
};

/// The pixels of the target whose centres lie in the box around three vertices.
/// @param x, y  their coordinates, 1/256 pixel
PixelBox centres_in_box(const std::int32_t (&x)[3], const std::int32_t (&y)[3], const Rect& target);

/// Appends the triangle as what it becomes, if a pixel centre of the grid's target lies in its box.
/// @return false if it has no area on the pixel grid
bool append_triangle(const ScreenTriangle& triangle, const TileGrid& grid, ScreenPrimitives& out);

}  // namespace velum
