#pragma once

/// The vector versions of the stages transform_vertices, assemble and set_up, for vertices and triangles that
/// need no clipping. Their references stand in geometry_stages.cpp; the results are the same to the bit.

#include <cstddef>
#include <cstdint>

#include "../base/counters.hpp"
#include "../base/isa.hpp"
#include "../visibility/raster_triangle.hpp"
#include "../visibility/tile_grid.hpp"
#include "../visibility/tile_raster.hpp"

namespace velum {

/// In place of a snapped coordinate: the vertex is outside a plane, behind the eye or not finite, and its
/// triangles take the plain path.
inline constexpr std::int32_t not_snapped = INT32_MIN;

/// A vertex on the picture: 1/256 pixel. Where it has no place there, x is not_snapped and y the outcode; 0
/// if it is not finite.
struct PlacedVertex {
  std::int32_t x;
  std::int32_t y;
};

struct TransformWork {
  const float* positions;  ///< x, y, z per vertex, object space
  std::size_t count;
  const double* clip_from_object;  ///< 16, column by column
  int width;                       ///< of the whole picture, pixels
  int height;
  double* clip;            ///< out: x, y, z, w per vertex; nullptr: not wanted
  std::uint8_t* outcodes;  ///< out; nullptr: not wanted
  PlacedVertex* placed;    ///< out
  float* nearness;  ///< out: the reversed depth in [0,1] of vertices that have a place; nullptr: not wanted
};
using TransformVertices = void (*)(const TransformWork& work);

struct SetUpWork {
  const std::uint32_t* indices;  ///< three per triangle, of the whole mesh
  std::uint32_t first;           ///< triangles first … last-1 are looked at
  std::uint32_t last;
  /// A triangle's id is this and its number or, where `primitives` is not null, what stands there for it.
  std::uint32_t first_primitive;
  const std::uint32_t* primitives;
  const float* positions;          ///< of the whole mesh: x, y, z per vertex, object space
  const double* clip_from_object;  ///< 16, column by column
  const PlacedVertex* placed;      ///< of the whole mesh, as TransformWork gave it
  const float* nearness;  ///< of the whole mesh, as TransformWork gave it; nullptr: SmallBounds::nearest
                          ///< is left to the caller
  int width;              ///< of the whole picture, pixels
  int height;
  int target_left, target_top, target_right, target_bottom;  ///< the pixels wanted
  int tile_columns;                                          ///< see TileGrid
  float sample_x, sample_y;  ///< from the pixel's centre to where depth is taken, pixels; see move_depth()
  bool cull_positive;        ///< leave out triangles whose determinant is > 0 …
  bool cull_negative;        ///< … < 0
  bool cull_zero;            ///< … = 0
  bool is_back_positive;     ///< which sign faces away
  // Out; each triangle becomes what is_small() and its box say.
  RasterTriangle* large;      ///< room for last - first
  SmallBounds* small_bounds;  ///< room for last - first + bounds_room
  std::uint32_t* small_refs;  ///< of the same triangles: first_ref and how many come before from `first` on
  std::uint32_t first_ref;
  FragmentArrays fragments;  ///< room for fragments_room(last - first)
  std::uint32_t* slow;       ///< triangles with a vertex that is not placed; room for last - first
};

/// How many of each were written: those with area whose box holds a pixel centre of the target.
struct SetUpResult {
  std::size_t large;
  std::size_t small;
  std::size_t fragments;
  std::size_t slow;
  PixelBox box;  ///< around all but the slow
};
using SetUpTriangles = SetUpResult (*)(const SetUpWork& work, Counters& counters);

/// The kernels for an instruction set. @pre is_available(isa), and not `reference`
TransformVertices transform_kernel(Isa isa);
SetUpTriangles set_up_kernel(Isa isa);
/// Its work is a SetUpWork; triangles are counted from `first` on.
SmallSource::SetUp set_up_small_kernel(Isa isa);

}  // namespace velum
