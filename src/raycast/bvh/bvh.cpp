#include "bvh.hpp"

namespace velum {

Bvh::Bvh(const TriangleSet& triangles, const BvhSettings& settings)
    : Accelerator(triangles), tree_(build_bvh(boxed_triangles(), settings)) {}

void Bvh::traverse(Search& search) const {
  tree_.traverse(
      search.ray, search.counters, [&search] { return search.limit(); },
      [&search](std::span<const std::uint32_t> ids) {
        for (const std::uint32_t id : ids) {
          search.test(id);
          if (search.is_done()) return false;
        }
        return true;
      });
}

}  // namespace velum
