#pragma once

#include <span>

#include "kd_tree.hpp"

namespace velum {

/// Rays that go through a tree together.
inline constexpr std::size_t kd_packet_size = 8;

/// The first hit of each ray, the same as KdTree::first_hit finds. Rays are taken eight at a time; eight
/// whose directions have the same signs go through the tree together, so that a node is fetched once for all
/// that want it (Wald, Slusallek, Benthin & Wagner 2001, "Interactive Rendering with Coherent Ray Tracing");
/// others, and all rays through a tree of split triangles, go one by one. Neighbouring pixels' rays gain by
/// it; the deeper in the tree, the fewer rays are left of a packet.
/// @param counters  a node that a packet visits counts once
/// @pre out.size() == rays.size()
void first_hits(const KdTree& tree, std::span<const Ray> rays, const Interval& range, CastCounters& counters,
                std::span<RayHit> out, const HitFilter& filter = {});

}  // namespace velum
