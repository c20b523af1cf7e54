#pragma once

#include "../accelerator.hpp"

namespace velum {

/// No structure at all: every ray is tested against every triangle. What the others are measured by.
class BruteForce final : public Accelerator {
 public:
  explicit BruteForce(const TriangleSet& triangles);
  std::size_t memory() const override { return ids_.size() * sizeof(ids_[0]); }

 private:
  void traverse(Search& search) const override;
  std::vector<std::uint32_t> ids_;  ///< of the triangles that can be hit
};

}  // namespace velum
