#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "../../base/ray.hpp"
#include "interval.hpp"

namespace velum {

/// Where the line of a ray meets a surface.
struct SurfaceHit {
  double t = 0.0;          ///< ray.at(t) is the point
  glm::dvec3 normal{0.0};  ///< of the surface there; unit length, outwards (a plane's: its own)
};

/// Where a line meets the boundary of a convex body: at most twice, in the order of t. Negative t count too:
/// the caller knows which part of the line is wanted.
struct SurfaceHits {
  int count = 0;
  std::array<SurfaceHit, 2> hits{};

  void add(const SurfaceHit& hit) { hits[static_cast<std::size_t>(count++)] = hit; }

  /// The first one in a range of t.
  std::optional<SurfaceHit> first_in(const Interval& range) const {
    for (int i = 0; i < count; ++i) {
      const SurfaceHit& hit = hits[static_cast<std::size_t>(i)];
      if (range.contains(hit.t)) return hit;
    }
    return {};
  }
};

/// Whether a ray leads anywhere: origin and direction finite, direction not zero. All others hit nothing.
inline bool is_usable(const Ray& ray) {
  const glm::dvec3 d = ray.direction;
  const double sum = (d.x - d.x) + (d.y - d.y) + (d.z - d.z) + (ray.origin.x - ray.origin.x) +
                     (ray.origin.y - ray.origin.y) + (ray.origin.z - ray.origin.z);
  return sum == 0.0 && !(d.x == 0.0 && d.y == 0.0 && d.z == 0.0);
}

}  // namespace velum
