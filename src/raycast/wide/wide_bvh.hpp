#pragma once

#include "../accelerator.hpp"
#include "wide_cast_kernels.hpp"
#include "wide_packet_kernels.hpp"
#include "wide_tree.hpp"

namespace velum {

/// A bounding volume hierarchy made for speed: eight children per node, four triangles per leaf, both met by
/// vectors (Dammertz, Hanika & Keller 2008, "Shallow Bounding Volume Hierarchies for Fast SIMD Ray Tracing of
/// Incoherent Rays"; Ernst & Greiner 2008, "Multi Bounding Volume Hierarchies"). Vectors only leave out what
/// the ray certainly does not hit; what is left is decided by intersect_watertight(), as everywhere.
class WideBvh final : public Accelerator {
 public:
  /// @param isa  which instructions cast rays; reference: plain loops in double. @pre is_available(isa)
  explicit WideBvh(const TriangleSet& triangles, Isa isa = Isa::best);
  std::size_t memory() const override { return tree_.memory(); }
  const WideTree& tree() const { return tree_; }

 private:
  void traverse(Search& search) const override;
  bool cast_alone(const Ray& ray, const Interval& range, Search::Aim aim, const HitFilter& filter,
                  CastCounters& counters, RayHit& hit, std::vector<RayHit>* all) const override;
  bool first_hits_together(std::span<const ViewRay> rays, std::span<RayHit> hits, CastCounters& counters,
                           const HitFilter& filter) const override;

  WideTree tree_;
  CastWideKernels cast_{};                  ///< nullptr: plain loops
  TraversePacket packet_kernel_ = nullptr;  ///< nullptr: ray by ray
  WideBounds float_bounds_{};
};

/// One of a block's triangles. @pre lane < 4
Triangle triangle_in(const TriangleBlock& block, std::size_t lane);

/// Asks intersect_watertight() about one of a block's triangles; what kernels call where a ray passes exactly
/// through an edge. @return whether it is hit; then t and the barycentric coordinates are set
bool decide_exactly(const PreparedRay& ray, const TriangleBlock& block, std::size_t lane, WideHit& hit);

/// The plain loops: the oracle of the kernels, and their stand-in for rays too large or too small for
/// float32.
void traverse_wide_reference(const WideTree& tree, Search& search);

}  // namespace velum
