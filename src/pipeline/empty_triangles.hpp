#pragma once

/// Tells, before anything is set up, which triangles cover no pixel centre: of a mesh whose triangles are
/// smaller than a pixel that is most of them.

#include <cstddef>
#include <cstdint>

#include "../base/counters.hpp"
#include "../base/isa.hpp"
#include "../spatial/corner_window.hpp"
#include "geometry_kernels.hpp"

namespace velum {

/// Triangles that have their vertices in common.
struct EmptyTrianglesWork {
  const PlacedVertex* placed;  ///< as TransformWork gave them
  std::uint32_t first_vertex;  ///< vertices first_vertex … first_vertex + vertex_count-1 are all that is used
  std::uint32_t vertex_count;
  const std::uint32_t* indices;     ///< three per triangle, into `placed`
  const std::uint16_t* corners[3];  ///< see MeshCluster: what is read where vertices are at most 65536
  const std::uint16_t* windows;     ///< of the corners, see MeshCluster
  const std::uint32_t* triangles;   ///< what is handed on for each
  std::uint32_t triangle_count;
  bool is_back_positive;  ///< see SetUpWork
  bool cull_positive, cull_negative;
  // Out: of the triangles that are left.
  std::uint32_t* kept_indices;    ///< room for three per triangle
  std::uint32_t* kept_triangles;  ///< room for one per triangle, and kept_room more
  std::int32_t* scratch;          ///< room for packed_room(vertex_count)
};

inline constexpr std::size_t kept_room = 16;
constexpr std::size_t packed_room(std::size_t vertex_count) {
  return vertex_count + window_corners + 16;
}

/// Copies those that may cover a pixel centre, in their order, and counts the others, as the stages would but
/// for their facing, which is that of the snapped corners: none counts as edge-on or reversed. Nothing is
/// left out where a vertex has no place on the picture, or where they are more than 65536 or 125 pixels or
/// more apart.
/// @return how many are left
using LeaveOutEmpty = std::uint32_t (*)(const EmptyTrianglesWork& work, Counters& counters);

/// The version for an instruction set. @pre is_available(isa), and not `reference`
LeaveOutEmpty empty_triangles_kernel(Isa isa);

/// What the kernels do, one triangle after the other.
std::uint32_t leave_out_empty_reference(const EmptyTrianglesWork& work, Counters& counters);

}  // namespace velum
