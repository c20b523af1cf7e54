#pragma once

#include <optional>
#include <span>

#include "../../base/ray.hpp"
#include "surface_hit.hpp"

namespace velum {

/// Where the line of a ray meets a planar polygon that is convex: in its plane, and on the same side of every
/// edge. The normal sees the corners counter-clockwise. Nothing for fewer than three corners or no area.
std::optional<SurfaceHit> intersect_convex_polygon(const Ray& ray, std::span<const glm::dvec3> corners);

/// The same for any planar polygon: a point is inside if a half-line from it crosses the outline an odd
/// number of times. Each edge owns its lower end only, so a half-line through a corner counts once.
/// Source: Haines 1994, "Point in Polygon Strategies" (crossings test).
std::optional<SurfaceHit> intersect_polygon(const Ray& ray, std::span<const glm::dvec3> corners);

}  // namespace velum
