#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "walk_counts.hpp"

namespace velum {

/// No triangle has this number.
inline constexpr std::uint32_t no_triangle = 0xFFFFFFFFu;

/// What a ray meets: a triangle of a mesh, or nothing (no_triangle, t infinite).
struct RayHit {
  double t = std::numeric_limits<double>::infinity();
  std::uint32_t triangle = no_triangle;
  glm::dvec3 barycentric{0.0};

  bool is_hit() const { return triangle != no_triangle; }
};

/// The order in which hits are met; of two at the same place the lower id comes first.
constexpr bool is_before(double t, std::uint32_t id, double other_t, std::uint32_t other_id) {
  return t < other_t || (t == other_t && id < other_id);
}

/// What casting rays cost. Deterministic for given rays and structures.
struct CastCounters : WalkCounts {
  std::uint64_t rays = 0;
  std::uint64_t mailbox = 0;  ///< triangles met again in another cell and not tested again
  std::uint64_t hits = 0;     ///< rays that hit something; all_hits: hits

  CastCounters& operator+=(const CastCounters& other) {
    rays += other.rays;
    nodes += other.nodes;
    boxes += other.boxes;
    tests += other.tests;
    mailbox += other.mailbox;
    hits += other.hits;
    return *this;
  }
};

}  // namespace velum
