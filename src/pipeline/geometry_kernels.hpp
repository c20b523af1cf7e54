#pragma once

/// The vector versions of the stages transform_vertices, assemble and set_up, for vertices and triangles that
/// need no clipping. Their references stand in geometry_stages.cpp; the results are the same to the bit.

#include <cstddef>
#include <cstdint>

#include "../base/isa.hpp"
#include "../visibility/raster_triangle.hpp"

namespace velum {

/// In place of a snapped coordinate: the vertex is outside a plane, behind the eye or not finite, and its
/// triangles take the plain path.
inline constexpr std::int32_t not_snapped = INT32_MIN;

/// A vertex on the picture: 1/256 pixel; x is not_snapped where it has no place there.
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
  double* clip;            ///< out: x, y, z, w per vertex
  std::uint8_t* outcodes;  ///< out
  PlacedVertex* placed;    ///< out
};
using TransformVertices = void (*)(const TransformWork& work);

/// What became of the triangles of one call; see Counters.
struct SetUpCounts {
  std::uint64_t accepted = 0;
  std::uint64_t back_facing = 0;
  std::uint64_t edge_on = 0;
  std::uint64_t culled = 0;
  std::uint64_t screen_triangles = 0;
  std::uint64_t zero_area = 0;
  std::uint64_t reversed = 0;
};

struct SetUpWork {
  const std::uint32_t* indices;  ///< three per triangle, of the whole mesh
  std::uint32_t first;           ///< triangles first … last-1 are looked at
  std::uint32_t last;
  std::uint32_t first_primitive;  ///< id of triangle 0
  const double* clip;             ///< of the whole mesh, as TransformWork gave it
  const PlacedVertex* placed;
  int width;  ///< of the whole picture, pixels
  int height;
  int target_left, target_top, target_right, target_bottom;  ///< the pixels wanted
  bool cull_positive;     ///< leave out triangles whose determinant is > 0 …
  bool cull_negative;     ///< … < 0
  bool cull_zero;         ///< … = 0
  bool is_back_positive;  ///< which sign faces away
  RasterTriangle* out;    ///< room for last - first
  std::uint32_t* slow;    ///< out: triangles with a vertex that is not placed; room for last - first
};

struct SetUpResult {
  std::size_t triangles;  ///< in out: those with area whose box holds a pixel centre of the target
  std::size_t slow;
};
using SetUpTriangles = SetUpResult (*)(const SetUpWork& work, SetUpCounts& counts);

/// The kernels for an instruction set. @pre is_available(isa), and not `reference`
TransformVertices transform_kernel(Isa isa);
SetUpTriangles set_up_kernel(Isa isa);

}  // namespace velum
