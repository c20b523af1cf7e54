#pragma once

#include <cstdint>

namespace velum {

/// The most levels a z-pyramid has: a picture of 32768 pixels a side has 16.
inline constexpr int most_pyramid_levels = 16;

/// What the hierarchical method did. Deterministic for given settings and, where a Renderer is used again,
/// for the frame before. Units: things counted, unless said otherwise.
struct HierarchyCounters {
  std::uint64_t batches = 0;         ///< times that triangles were drawn and the pyramid brought up to date
  std::uint64_t nodes_visited = 0;   ///< octree nodes whose box was brought to the picture
  std::uint64_t nodes_outside = 0;   ///< of them beyond the view volume or the part of the picture wanted
  std::uint64_t nodes_hidden = 0;    ///< left out, with all below, since the pyramid is nearer
  std::uint64_t clusters_away = 0;   ///< left out since all their triangles face away (or, culling front
                                     ///< faces, towards the eye)
  std::uint64_t clusters_drawn = 0;  ///< nodes whose own triangles were transformed
  std::uint64_t clusters_remembered = 0;                    ///< of them drawn first, seen in the frame before
  std::uint64_t triangles_left_out = 0;                     ///< never transformed
  std::uint64_t polygons_tested = 0;                        ///< against the pyramid, one by one
  std::uint64_t polygons_hidden = 0;                        ///< of them left out
  std::uint64_t nodes_hidden_at[most_pyramid_levels] = {};  ///< by the level that decided
  std::uint64_t polygons_hidden_at[most_pyramid_levels] = {};  ///< by the level that decided
  std::uint64_t octree_bytes = 0;  ///< memory that the octrees over instances and meshes hold, bytes; of
                                   ///< several frames the most

  HierarchyCounters& operator+=(const HierarchyCounters& other);
};

}  // namespace velum
