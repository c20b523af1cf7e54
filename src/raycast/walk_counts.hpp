#pragma once

#include <cstdint>

namespace velum {

/// What taking rays through a structure costs.
struct WalkCounts {
  std::uint64_t nodes = 0;  ///< nodes or cells that the rays went into
  std::uint64_t boxes = 0;  ///< intersections with boxes or dividing planes
  std::uint64_t tests = 0;  ///< intersections with triangles
};

}  // namespace velum
