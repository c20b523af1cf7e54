#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace velum {

/// Plane projections as singular 4×4 matrices on homogeneous column vectors: determinant 0, rank 3; the
/// kernel is the centre. Two matrices that differ by a factor are the same projection. Source: the lecture
/// "Projektionen und Sichtbarkeit"; general form: e.g. Blinn 1988, "Me and My (Fake) Shadow".

/// P = (π·c)·I - c·πᵀ: onto the plane π from the homogeneous centre c (a point, or a direction with w = 0).
/// @throws Error (usage) if π·c = 0: the centre lies in the plane
glm::dmat4 project_onto_plane(const glm::dvec4& plane, const glm::dvec4& centre);

/// The lecture's principal views: onto z = z0 (x = x0, y = y0) along that axis.
glm::dmat4 project_onto_x(double x0 = 0.0);
glm::dmat4 project_onto_y(double y0 = 0.0);
glm::dmat4 project_onto_z(double z0 = 0.0);

/// The lecture's oblique projection onto the xy plane along r: x' = x - (rx/rz)·z, y' = y - (ry/rz)·z, z' =
/// 0.
/// @throws Error (usage) if r.z = 0
glm::dmat4 oblique_onto_xy(const glm::dvec3& r);

/// The lecture's central projection onto the xy plane from (0, 0, -d): x' = x·d/(z+d). Two homogeneous forms,
/// equal up to the factor d.
/// @throws Error (usage) unless d is finite and not 0
glm::dmat4 central_onto_xy(double d);          ///< bottom row (0, 0, 1/d, 1)
glm::dmat4 central_onto_xy_times_d(double d);  ///< bottom row (0, 0, 1, d)

}  // namespace velum
