#pragma once

#include "../../spatial/bounding_volume.hpp"
#include "../accelerator.hpp"

namespace velum {

/// Where the whole line of a ray is inside a volume, which counts as larger by the ray's margin; for a convex
/// hull or k-DOP by Cyrus & Beck 1978. Empty only where the line misses all that is in the volume.
Interval interval_inside(const PreparedRay& ray, const BoundingVolume& volume);

/// One volume around all triangles: rays that miss it are tested against none, others against every one. The
/// lecture's T = c_BV + p_BV·n·c_P. (As every structure does, it asks the axis-aligned box first.)
class BoundedBruteForce final : public Accelerator {
 public:
  BoundedBruteForce(const TriangleSet& triangles, VolumeKind kind);
  std::size_t memory() const override {
    return ids_.empty() ? 0 : volume_.memory() + ids_.size() * sizeof(ids_[0]);
  }
  const BoundingVolume& volume() const { return volume_; }

 private:
  void traverse(Search& search) const override;
  BoundingVolume volume_;
  std::vector<std::uint32_t> ids_;  ///< of the triangles that can be hit
};

}  // namespace velum
