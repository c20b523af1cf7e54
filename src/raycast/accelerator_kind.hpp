#pragma once

#include <span>

namespace velum {

/// The structures that find what a ray hits without looking at every triangle. All give the same answers.
enum class AcceleratorKind {
  brute_force,
  bvh,         ///< wide, for speed
  binary_bvh,  ///< the lecture's
  kd_tree,
  grid,
  nested_grid,
  octree,
  bsp
};

/// Name and kind, as on the command line.
struct AcceleratorName {
  const char* name;
  AcceleratorKind kind;
};
std::span<const AcceleratorName> accelerator_names();

}  // namespace velum
