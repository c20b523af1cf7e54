#pragma once

#include <glm/vec3.hpp>

#include "../base/aabb.hpp"
#include "../base/ray.hpp"
#include "intersection/interval.hpp"
#include "search.hpp"

namespace velum {

/// How a ray that starts on a surface, for a shadow or a mirror image, is kept from meeting that surface
/// again: the place where it starts is rounded and lies a little before or behind the surface. The cures of
/// the lectures "Raytracing" and "Interactive Computer Graphics" 11.
enum class SelfHitCure {
  none,              ///< shadow acne
  direction_offset,  ///< starts later, the more so the flatter it leaves: as far as rounding reaches; default
  normal_offset,     ///< starts a given distance above the surface
  global_epsilon,    ///< hits nearer than a given distance do not count
  implicit_sign,     ///< a triangle on whose plane it starts is not met: its equation there has no sign
};

/// A place on a surface, from a hit.
struct SurfacePlace {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  ///< of the triangle; any length but 0, to either side
  double error = 0.0;      ///< how far rounding may have moved the position: see position_error()
};

/// An upper bound of the distance between Ray::at(t) of a hit and its triangle, and between the hit itself
/// and the triangle: a multiple of the margin that boxes get (PreparedRay::margin).
/// @param bounds  of all that can be hit; in the space of the ray
double position_error(const Ray& ray, double t, const Aabb& bounds);

/// A ray that leaves a surface and the part of it that counts.
struct LeavingRay {
  Ray ray;
  Interval range;
};

/// @param direction  t = 1 is reached at position + direction, whatever the cure
/// @param end        the t that is wanted last
/// @param epsilon    of normal_offset and global_epsilon: a distance. The others take what `place.error` says
LeavingRay leave_surface(const SurfacePlace& place, const glm::dvec3& direction, double end, SelfHitCure cure,
                         double epsilon);

/// Leaves out the triangles on whose planes a place lies, as far as rounding can tell: for
/// SelfHitCure::implicit_sign. (The lecture asks whether the new ray starts inside or outside by the sign of
/// the implicit equation. A plane is met once, so where the sign is lost in rounding that hit was it.)
class OnSurface {
 public:
  OnSurface(const TriangleSet& triangles, const SurfacePlace& place) : triangles_(triangles), place_(place) {}

  bool holds(std::uint32_t triangle) const;
  /// Valid as long as this.
  HitFilter filter() const {
    return {[](const void* self, std::uint32_t triangle) {
              return !static_cast<const OnSurface*>(self)->holds(triangle);
            },
            this};
  }

 private:
  TriangleSet triangles_;
  SurfacePlace place_;
};

}  // namespace velum
