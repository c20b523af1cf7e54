#pragma once

#include "../intersection/prepared_ray.hpp"
#include "wide_kernels.hpp"

namespace velum {

/// The number that the float32 t of a WideRay are larger by: the length of the ray's direction along its
/// longest axis.
double scale_of(const PreparedRay& ray);

/// A float32 that is not smaller, or not larger, than a double.
float rounded_up(double v);
float rounded_down(double v);

/// Makes the ray for the vector kernels, in place: a copy would wait for the many small numbers.
/// @return false if numbers are too large or too small for float32
///
/// An interval that is computed from it holds the interval that PreparedRay::through() gives for the same box
/// in double, as far as the ray is within the bounds: the margin, 2^-21 of the reach and 2^-22 of the origin,
/// is more than the rounding of the origin (2^-24 of it), of the difference, the inverse and the product
/// (2^-24 of the reach each). Along an axis in which the direction is less than 2^-40 of its longest, the ray
/// moves by less than the margin; the inverse is kept at 2^40 there.
bool make_wide_ray(const PreparedRay& ray, WideRay& wide);

}  // namespace velum
