#include "brute_force.hpp"

namespace velum {

BruteForce::BruteForce(const TriangleSet& triangles) : Accelerator(triangles) {
  for (const BoxedItem& item : boxed_triangles()) ids_.push_back(item.id);
}

void BruteForce::traverse(Search& search) const {
  for (const std::uint32_t id : ids_) {
    search.test(id);
    if (search.is_done()) return;
  }
}

}  // namespace velum
