#include "accelerator.hpp"
#include "brute_force/brute_force.hpp"
#include "bvh/bvh.hpp"
#include "kd/kd_tree.hpp"
#include "space/bsp_tree.hpp"
#include "space/grid.hpp"
#include "space/octree_caster.hpp"
#include "wide/wide_bvh.hpp"

namespace velum {

std::unique_ptr<Accelerator> build_accelerator(AcceleratorKind kind, const TriangleSet& triangles, Isa isa) {
  switch (kind) {
    case AcceleratorKind::brute_force:
      return std::make_unique<BruteForce>(triangles);
    case AcceleratorKind::kd_tree:
      return std::make_unique<KdTree>(triangles);
    case AcceleratorKind::grid:
      return std::make_unique<Grid>(triangles);
    case AcceleratorKind::nested_grid:
      return std::make_unique<Grid>(triangles, GridSettings{1.0, 3, 16});
    case AcceleratorKind::octree:
      return std::make_unique<OctreeCaster>(triangles);
    case AcceleratorKind::bsp:
      return std::make_unique<BspTree>(triangles);
    case AcceleratorKind::binary_bvh:
      return std::make_unique<Bvh>(triangles);
    case AcceleratorKind::bvh:
      break;
  }
  return std::make_unique<WideBvh>(triangles, isa);
}

}  // namespace velum
