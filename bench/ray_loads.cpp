#include "ray_loads.hpp"

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace velum_bench {
namespace {

using namespace velum;

/// Beyond which share of the scene's diagonal a ray that starts on a surface may hit something.
constexpr double least_distance = 1e-4;

/// SplitMix64 (Steele, Lea & Flood 2014).
class Random {
 public:
  /// In [0, 1).
  double uniform() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t state_ = 1;
};

std::vector<ViewRay> primary_rays(const BenchScene& bench) {
  const CameraRays camera(bench.camera.viewing_transform(bench.aspect()), {bench.width, bench.height});
  std::vector<ViewRay> rays;
  rays.reserve(static_cast<std::size_t>(bench.pixels()));
  for (int top = 0; top < bench.height; top += 2) {
    for (int left = 0; left < bench.width; left += 4) {
      for (int i = 0; i < 8; ++i) rays.push_back(camera.through(left + i % 4 + 0.5, top + i / 4 + 0.5));
    }
  }
  return rays;
}

glm::dvec3 normal_of(const Triangle& triangle) {
  return glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a));
}

/// About a unit vector, as likely as the cosine of the angle between them.
glm::dvec3 direction_about(const glm::dvec3& normal, Random& random) {
  const double height2 = random.uniform();
  const double angle = 2.0 * std::numbers::pi * random.uniform();
  const glm::dvec3 aside = std::fabs(normal.x) > 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(aside, normal));
  const glm::dvec3 v = glm::cross(normal, u);
  return normal * std::sqrt(height2) + (u * std::cos(angle) + v * std::sin(angle)) * std::sqrt(1.0 - height2);
}

/// Above the camera and to its left.
glm::dvec3 light_of(const BenchScene& bench, double diagonal) {
  const CameraRays camera(bench.camera.viewing_transform(bench.aspect()), {bench.width, bench.height});
  const auto near = [&](double x, double y) {
    return camera.through(x * bench.width, y * bench.height).ray.origin;
  };
  const glm::dvec3 up = glm::normalize(near(0.5, 0.0) - near(0.5, 1.0));
  const glm::dvec3 left = glm::normalize(near(0.0, 0.5) - near(1.0, 0.5));
  return near(0.5, 0.5) + (0.25 * up + 0.15 * left) * diagonal;
}

}  // namespace

RayLoads make_ray_loads(const BenchScene& bench, const Accelerator& caster) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double diagonal = glm::length(caster.bounds().upper - caster.bounds().lower);
  const glm::dvec3 light = light_of(bench, diagonal);
  RayLoads loads{{"primary", primary_rays(bench)}, {"incoherent", {}}, {"shadow", {}}};
  Random random;
  CastCounters counters;
  for (const ViewRay& primary : loads.primary.rays) {
    const RayHit hit = caster.first_hit(primary.ray, primary.range, counters);
    if (!hit.is_hit()) continue;
    const glm::dvec3 point = primary.ray.at(hit.t);
    glm::dvec3 normal = normal_of(caster.triangles()[hit.triangle]);
    if (glm::dot(normal, primary.ray.direction) > 0.0) normal = -normal;
    const double nearest = least_distance * diagonal;
    loads.incoherent.rays.push_back({{point, direction_about(normal, random)}, {nearest, infinity}});
    loads.shadow.rays.push_back({{point, light - point}, {nearest / glm::length(light - point), 1.0}});
  }
  return loads;
}

}  // namespace velum_bench
