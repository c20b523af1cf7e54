#include "wide_bvh.hpp"

#include <limits>

#include "wide_ray.hpp"

namespace velum {
namespace {

/// Decides what a kernel proposes.
struct Decision {
  Search& search;
  double scale;

  float meet(const TriangleBlock& block, std::uint32_t lanes) {
    for (std::size_t lane = 0; lanes != 0; ++lane, lanes >>= 1) {
      if ((lanes & 1u) == 0) continue;
      search.decide(block.id[lane], triangle_in(block, lane));
      if (search.is_done()) return -std::numeric_limits<float>::infinity();
    }
    return rounded_up(search.limit() * scale);
  }
};

}  // namespace

Triangle triangle_in(const TriangleBlock& block, std::size_t lane) {
  const auto corner = [&](std::size_t i) {
    const auto& axes = block.corner[i];
    return glm::dvec3(glm::vec3(axes[0][lane], axes[1][lane], axes[2][lane]));
  };
  return {corner(0), corner(1), corner(2)};
}

WideBvh::WideBvh(const TriangleSet& triangles, Isa isa)
    : Accelerator(triangles),
      tree_(build_wide_tree(triangles, isa)),
      kernel_(isa == Isa::reference ? nullptr : traverse_wide_kernel(isa)),
      packet_kernel_(isa == Isa::reference ? nullptr : traverse_packet_kernel(isa)) {}

void WideBvh::traverse(Search& search) const {
  if (tree_.is_empty()) return;
  WideRay ray;
  if (kernel_ == nullptr || !make_wide_ray(search.ray, ray)) {
    traverse_wide_reference(tree_, search);
    return;
  }
  Decision decision{search, scale_of(search.ray)};
  const WideMeeting meeting{&decision, [](void* context, const TriangleBlock& block, std::uint32_t lanes) {
                              return static_cast<Decision*>(context)->meet(block, lanes);
                            }};
  WideCounts counts;
  kernel_(tree_.view(), ray, meeting, counts);
  search.counters.nodes += counts.nodes;
  search.counters.boxes += counts.boxes;
  search.counters.tests += counts.tests;
}

}  // namespace velum
