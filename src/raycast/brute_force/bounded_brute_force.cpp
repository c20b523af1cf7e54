#include "bounded_brute_force.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "../intersection/sphere_intersection.hpp"

namespace velum {
namespace {

/// In the space where the volume is a ball of radius 1, made larger by what the ray's margin is there and by
/// what the way there rounds.
Interval interval_inside_round(const PreparedRay& ray, const BoundingVolume& volume) {
  const glm::dmat3& m = volume.ball_from_space;
  const glm::dvec3 offset = m * (ray.ray.origin - volume.centre);
  const double stretch = glm::length(m[0]) + glm::length(m[1]) + glm::length(m[2]);
  const double margin = 2.0 * ray.margin * stretch + 0x1.0p-44 * (1.0 + glm::length(offset));
  return ball_interval(offset, m * ray.ray.direction, 1.0 + margin);
}

}  // namespace

Interval interval_inside(const PreparedRay& ray, const BoundingVolume& volume) {
  if (volume.is_round()) return interval_inside_round(ray, volume);
  Interval inside;
  for (const Plane& plane : volume.planes) {
    const glm::dvec3& n = plane.normal;
    // Times √3 at most: the margin is one per axis. The rest is room for rounding.
    const double margin = 4.0 * ray.margin;
    const double height = plane.signed_value(ray.ray.origin) - margin;
    const double speed = glm::dot(n, ray.ray.direction);
    if (speed == 0.0) {
      if (height > 0.0) return Interval::empty();
      continue;
    }
    const double t = -height / speed;
    (speed > 0.0 ? inside.upper : inside.lower) =
        speed > 0.0 ? std::min(inside.upper, t) : std::max(inside.lower, t);
    if (inside.is_empty()) return inside;
  }
  return inside;
}

BoundedBruteForce::BoundedBruteForce(const TriangleSet& triangles, VolumeKind kind) : Accelerator(triangles) {
  std::vector<glm::vec3> points;
  for (const BoxedItem& item : boxed_triangles()) {
    ids_.push_back(item.id);
    for (int corner = 0; corner < 3; ++corner) {
      points.push_back(triangles.positions[triangles.triangles[item.id][corner]]);
    }
  }
  if (!points.empty()) volume_ = bounding_volume(kind, points);
}

void BoundedBruteForce::traverse(Search& search) const {
  ++search.counters.boxes;
  // The whole line: where a ray grazes a triangle, its t is known less well than where it is.
  if (interval_inside(search.ray, volume_).is_empty()) return;
  for (const std::uint32_t id : ids_) {
    search.test(id);
    if (search.is_done()) return;
  }
}

}  // namespace velum
