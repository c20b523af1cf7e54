#include "leave_surface.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace velum {
namespace {

double largest(const glm::dvec3& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// Sine of the angle between a direction and the surface, with a floor: no offset is without end.
double steepness(const glm::dvec3& direction, const glm::dvec3& normal) {
  constexpr double least = 0x1.0p-12;
  const double lengths = std::sqrt(glm::dot(direction, direction) * glm::dot(normal, normal));
  return lengths > 0.0 ? std::max(std::fabs(glm::dot(direction, normal)) / lengths, least) : least;
}

}  // namespace

double position_error(const Ray& ray, double t, const Aabb& bounds) {
  constexpr double factor = 0x1.0p-45;  // eight times the margin's
  const glm::dvec3 lower = bounds.lower - ray.origin, upper = bounds.upper - ray.origin;
  return factor * std::max({largest(lower), largest(upper), largest(ray.origin), largest(ray.at(t))});
}

LeavingRay leave_surface(const SurfacePlace& place, const glm::dvec3& direction, double end, SelfHitCure cure,
                         double epsilon) {
  LeavingRay leaving{{place.position, direction}, {0.0, end}};
  const double length = std::sqrt(glm::dot(direction, direction));
  switch (cure) {
    case SelfHitCure::none:
    case SelfHitCure::implicit_sign:
      break;
    case SelfHitCure::direction_offset:
      leaving.range.lower = place.error / (steepness(direction, place.normal) * length);
      break;
    case SelfHitCure::global_epsilon:
      leaving.range.lower = epsilon / length;
      break;
    case SelfHitCure::normal_offset: {
      const double side = glm::dot(direction, place.normal) < 0.0 ? -1.0 : 1.0;
      const double size = std::sqrt(glm::dot(place.normal, place.normal));
      const glm::dvec3 by = place.normal * (side * epsilon / size);
      leaving.ray = {place.position + by, direction - by};
      break;
    }
  }
  return leaving;
}

bool OnSurface::holds(std::uint32_t triangle) const {
  const Triangle t = triangles_[triangle];
  const glm::dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
  const double size = std::sqrt(glm::dot(normal, normal));
  return std::fabs(glm::dot(normal, place_.position - t.a)) <= place_.error * size;
}

}  // namespace velum
