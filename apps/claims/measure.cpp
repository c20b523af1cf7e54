#include "measure.hpp"

#include <algorithm>
#include <ctime>
#include <glm/geometric.hpp>
#include <limits>

namespace velum_claims {

using namespace velum;

double Numbers::next() {
  state += 0x9E3779B97F4A7C15ull;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

glm::dvec3 Numbers::on_sphere() {
  for (;;) {
    const glm::dvec3 p = point();
    const double length = glm::length(p);
    if (length <= 1.0 && length > 0.01) return p / length;
  }
}

double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double least_time(int runs, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < runs; ++i) {
    const double begin = processor_time();
    work();
    least = std::min(least, processor_time() - begin);
  }
  return least;
}

std::vector<Ray> random_lines(const Aabb& bounds, int count, std::uint64_t seed) {
  Numbers numbers{seed};
  const glm::dvec3 centre = bounds.centre();
  const double radius = glm::length(bounds.size()) * 0.5;
  std::vector<Ray> lines;
  while (static_cast<int>(lines.size()) < count) {
    // Two places on a sphere, all alike, are a line of the measure that motions leave alone.
    const glm::dvec3 a = centre + radius * numbers.on_sphere(), b = centre + radius * numbers.on_sphere();
    if (glm::length(b - a) > 1e-6 * radius) lines.push_back({a, b - a});
  }
  return lines;
}

std::vector<ViewRay> camera_rays(const Camera& camera, int width, int height) {
  const double aspect = static_cast<double>(width) / height;
  const CameraRays rays(camera.viewing_transform(aspect), {width, height});
  std::vector<ViewRay> all;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) all.push_back(rays.through(x + 0.5, y + 0.5));
  }
  return all;
}

CostPerRay cost_of(const Accelerator& structure, const std::vector<Ray>& rays, int runs) {
  CastCounters counters;
  const double seconds = least_time(runs, [&] {
    counters = {};
    for (const Ray& ray : rays) structure.first_hit(ray, {0.0, 1.0}, counters);
  });
  const auto n = static_cast<double>(rays.size());
  const auto share = [n](std::uint64_t count) { return static_cast<double>(count) / n; };
  return {share(counters.nodes), share(counters.boxes), share(counters.tests), share(counters.hits),
          seconds / n * 1e9};
}

}  // namespace velum_claims
