#pragma once

#include <string>

#include "kd_arrays.hpp"

namespace velum {

/// What is wrong with a tree from elsewhere, or nothing. Through a tree without fault every ray finds an end
/// and reads only what is there: the nodes are one tree in preorder, no deeper than the stacks; every plane
/// lies strictly inside its cell; the leaves share out the ids, which are all below `triangles`. Whether the
/// leaves hold the right triangles is not asked.
std::string fault_in(const KdArrays& tree, std::uint32_t triangles);

}  // namespace velum
