#pragma once

#include <cstddef>
#include <vector>

#include "../pipeline/explain_ray.hpp"

namespace velum {

/// A part of a traversal that fits into one picture: a step and what hangs below it, a few levels deep.
struct RayPanel {
  std::size_t root = 0;            ///< place in RayExplanation::traversal
  std::vector<std::size_t> steps;  ///< the same of all that is shown, root first, in the order of the steps
};

/// Divides a traversal into panels, in the order in which the ray comes by: what was entered on a panel's
/// deepest level is the root of one of its own.
/// @param levels  of steps below the root, ≥ 1
/// @param depth   steps of deeper levels are left out
/// @param most    if there would be more panels, those that do not lead to the hit are left out first, the
///                last ones first; ≥ 1
std::vector<RayPanel> ray_panels(const std::vector<RayStep>& traversal, int levels, int depth,
                                 std::size_t most);

}  // namespace velum
