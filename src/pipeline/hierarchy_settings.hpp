#pragma once

#include <cstdint>

#include "../spatial/octree.hpp"

namespace velum {

/// What is tested against the z-pyramid before it is drawn.
enum class HierarchyUse {
  both,      ///< octree nodes, then the polygons of those that may be seen
  octree,    ///< nodes of the octrees over instances and meshes
  polygons,  ///< each polygon by itself; nothing is left out before it is transformed
};

/// Settings of VisibilityMethod::hierarchical. None of them changes a byte of the picture.
struct HierarchySettings {
  HierarchyUse use = HierarchyUse::both;
  bool culls_frustum = true;      ///< leaves out nodes beyond the view volume
  bool culls_pyramid = true;      ///< leaves out nodes that the pyramid hides
  bool culls_cones = true;        ///< leaves out nodes whose triangles all face the way that is culled
  bool remembers_visible = true;  ///< a Renderer draws first what was seen in the frame before
  OctreePlacement placement = OctreePlacement::pushed_down;  ///< of triangles across the cubes' middles
  std::uint32_t leaf_size = 0;   ///< triangles in an octree's leaf at most; 0: chosen
  std::uint32_t batch_size = 0;  ///< triangles drawn before the pyramid is brought up to date; 0: chosen
};

}  // namespace velum
