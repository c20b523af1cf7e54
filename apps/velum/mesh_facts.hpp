#pragma once

#include <cstdint>
#include <velum/velum.hpp>

namespace velum_app {

/// What `velum info` tells of a mesh beyond its sizes.
struct MeshFacts {
  std::uint64_t welded_vertices = 0;  ///< distinct positions
  std::uint64_t zero_area = 0;        ///< triangles that use one position twice
  std::uint64_t skipped = 0;          ///< triangles with a position that is not finite: they are not drawn
  std::uint64_t edges = 0;            ///< of the other triangles
  std::uint64_t boundary_edges = 0;   ///< edges with one triangle
  std::uint64_t irregular_edges = 0;  ///< edges with three triangles or more, or two that run the same way
  std::uint64_t not_finite = 0;       ///< positions with NaN or infinity

  /// There is a surface, and every edge belongs to two triangles that run along it in opposite directions.
  bool is_closed() const { return edges > 0 && skipped == 0 && boundary_edges == 0 && irregular_edges == 0; }
};

/// Edges are told apart by position: vertices at equal positions count as one.
MeshFacts facts_of(const velum::Mesh& mesh);

}  // namespace velum_app
