#pragma once

#include "../../base/aabb.hpp"
#include "../../base/ray.hpp"
#include "interval.hpp"

namespace velum {

/// For which t the ray's line is inside a box, the boundary included. Empty for an empty box and for a ray
/// that is not usable.
///
/// As the lecture "Raytracing" has it: the box is three slabs, each slab an interval of t, the box their
/// common part. Where the ray runs along a slab (v = 0), the interval is everything or nothing. The lecture's
/// case with t* undefined for a *plane* is the reason to ask for the slab instead.
Interval box_interval_by_cases(const Ray& ray, const Aabb& box);

/// The same without branches: v = 0 gives t = ±infinity by itself, and the NaN of 0·infinity (the ray runs in
/// the boundary) is passed over by the order of the comparisons.
/// Source: Williams, Barrus, Morley & Shirley 2005, "An Efficient and Robust Ray-Box Intersection Algorithm".
Interval box_interval_branchless(const Ray& ray, const Aabb& box);

}  // namespace velum
