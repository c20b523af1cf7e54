#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace velum {

/// Whether velum was built with Qhull (the CMake option VELUM_QHULL).
bool has_convex_hull();

/// The outer unit normals of the convex hull's facets, by Qhull (Barber, Dobkin & Huhdanpaa 1996, "The
/// Quickhull Algorithm for Convex Hulls"); none where the points have no volume.
/// @throws Error (usage) where velum was built without Qhull
std::vector<glm::dvec3> convex_hull_normals(std::span<const glm::vec3> points);

}  // namespace velum
