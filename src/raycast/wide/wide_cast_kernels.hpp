#pragma once

#include <cstdint>

#include "../../base/isa.hpp"
#include "wide_kernels.hpp"

namespace velum {

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
  const float* bounds;      ///< of the tree: lower x, y, z, upper x, y, z
  void* context;            ///< for the following
  /// Whether a triangle counts; nullptr: all do.
  bool (*accepts)(const void* context, std::uint32_t triangle);
  const void* filter_context;
  /// intersect_watertight() for a ray that passes exactly through an edge.
  /// @return whether it is a hit; then t and the barycentric coordinates are set
  bool (*decide)(void* context, const TriangleBlock& block, std::size_t lane, WideHit& hit);
};

/// Casts one ray: boxes in float32, triangles four at once by the operations of intersect_watertight(), so
/// with its results to the bit.
/// @param hit  nothing yet: t infinite, no triangle
/// @return false: numbers are too large or too small for float32, and nothing was done
/// @pre the tree is not empty
using CastWide = bool (*)(const WideTreeView& tree, const WideQuery& query, WideHit& hit, WideCounts& counts);

struct CastWideKernels {
  CastWide first;  ///< the first hit
  CastWide any;    ///< any hit
};

/// @pre is_available(isa), and not `reference`
CastWideKernels cast_wide_kernels(Isa isa);

}  // namespace velum
