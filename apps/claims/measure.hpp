#pragma once

#include <cstdint>
#include <functional>
#include <vector>
#include <velum/velum.hpp>

namespace velum_claims {

/// Seeded numbers, the same on every machine (Vigna's splitmix64).
struct Numbers {
  std::uint64_t state;

  double next();  ///< 0 ≤ x < 1
  glm::dvec3 point() { return {2.0 * next() - 1.0, 2.0 * next() - 1.0, 2.0 * next() - 1.0}; }
  glm::dvec3 on_sphere();  ///< of radius 1, all places alike
};

/// Seconds of processor time of this process.
double processor_time();
/// The least of a few runs, seconds.
double least_time(int runs, const std::function<void()>& work);

/// Lines through a sphere around the bounds, all alike: each convex body in it is met as often as its surface
/// says. They start and end outside.
std::vector<velum::Ray> random_lines(const velum::Aabb& bounds, int count, std::uint64_t seed = 1);

/// The rays of a camera through the pixels' centres, row by row.
std::vector<velum::ViewRay> camera_rays(const velum::Camera& camera, int width, int height);

/// What casting many rays cost, for each ray.
struct CostPerRay {
  double nodes = 0.0, boxes = 0.0, tests = 0.0, hits = 0.0;
  double nanoseconds = 0.0;

  double steps() const { return nodes + tests; }
};
/// First hits. @param runs  of which the least time counts
CostPerRay cost_of(const velum::Accelerator& structure, const std::vector<velum::Ray>& rays, int runs = 2);

}  // namespace velum_claims
