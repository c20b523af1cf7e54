#pragma once

#include <cstdint>

#include "../../base/isa.hpp"
#include "../walk_counts.hpp"
#include "wide_nodes.hpp"

namespace velum {

/// The bounds of a tree: x, y, z.
struct WideBounds {
  float lower[3], upper[3];
};

/// As RayHit, in plain numbers.
struct WideHit {
  double t;
  std::uint32_t triangle;
  double barycentric[3];
};

/// A ray for casting, and what it is to find.
struct WideQuery {
  const double* origin;     ///< x, y, z
  const double* direction;  ///< x, y, z
  double lower, upper;      ///< the t that are wanted
  const WideBounds* bounds;
  void* context;  ///< for decide() and add()
  /// Whether a triangle counts; nullptr: all do.
  bool (*accepts)(const void* context, std::uint32_t triangle);
  const void* filter_context;
  /// intersect_watertight() for a ray that passes exactly through an edge.
  /// @return whether it is a hit; then t and the barycentric coordinates are set
  bool (*decide)(void* context, const TriangleBlock& block, std::size_t lane, WideHit& hit);
  /// Told every hit, where all are wanted.
  void (*add)(void* context, const WideHit& hit);
};

/// Casts one ray: boxes in float32, triangles four at once by the operations of intersect_watertight(), so
/// with its results to the bit.
/// @param hit  nothing yet: t infinite, no triangle; its barycentric coordinates are set only with a triangle
/// @return false: numbers are too large or too small for float32, and nothing was done
/// @pre the tree is not empty
using CastWide = bool (*)(const WideTreeView& tree, const WideQuery& query, WideHit& hit, WalkCounts& counts);

struct CastWideKernels {
  CastWide first;  ///< the first hit
  CastWide any;    ///< any hit
  CastWide all;    ///< all of them go to add(); none to `hit`
};

/// @pre is_available(isa), and not `reference`
CastWideKernels cast_wide_kernels(Isa isa);

}  // namespace velum
