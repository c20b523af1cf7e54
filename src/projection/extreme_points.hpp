#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "camera_axes.hpp"

namespace velum {

/// The points that can touch a picture's border, for any camera with these axes: the corners of the convex
/// hulls of the points' shadows along the camera's x and y axes. (A border is a plane through one of these
/// axes' directions, so it only ever touches such a corner.)
/// @param origin  a world point near the others: differences to it keep their digits
std::vector<glm::dvec3> extreme_points(std::span<const glm::dvec3> points, const CameraAxes& axes,
                                       const glm::dvec3& origin);

}  // namespace velum
