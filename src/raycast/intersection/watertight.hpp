#pragma once

#include <optional>

#include "prepared_ray.hpp"
#include "triangle_intersection.hpp"

namespace velum {

/// The one routine that decides whether a ray hits a triangle, and where. Sheared so that the ray runs along
/// an axis, the triangle is a flat one about the origin; three edge functions say on which side of each edge
/// the ray passes. Neighbours compute the same value for a common edge, so no ray slips through between them.
/// Source: Woop, Benthin & Wald 2013, "Watertight Ray/Triangle Intersection". Here:
///
/// - everything is in double, and a rounded value 0 is decided exactly (two_product) instead of in a wider
///   type;
/// - what is exactly on an edge belongs to one of the neighbours, by the raster's top-left rule: a closed
///   surface is hit once per sheet, not twice;
/// - t is put inside the interval of the triangle's own box, which it can leave by rounding when the ray
///   grazes the triangle; where that interval is empty, there is no hit. See PreparedRay.
///
/// Both sides are seen. Nothing for triangles without area, rays in the triangle's plane, and NaN anywhere.
/// @pre the triangle lies in the bounds that the ray was prepared for
std::optional<TriangleHit> intersect_watertight(const PreparedRay& ray, const Triangle& triangle);

}  // namespace velum
