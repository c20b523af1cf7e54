#pragma once

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "../base/plane.hpp"

namespace velum {

/// Which side of a triangle is seen. Exactly edge-on counts as front: dropping it could open a hole between
/// its neighbours.
enum class Facing { front, back };

/// The determinant of the columns (x, y, w) of three clip-space points, in one written-down order: > 0 if
/// they are counter-clockwise in the picture, < 0 if clockwise, 0 if edge-on. Right without clipping, also
/// where some w ≤ 0. Taken from differences to the first point, so that small triangles lose few digits and
/// repeated points and walls seen along their own plane give exactly 0.
/// Source: Olano & Greer 1997, "Triangle Scan Conversion using 2D Homogeneous Coordinates".
inline double homogeneous_determinant(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
  const glm::dvec3 origin(a.x, a.y, a.w);
  const glm::dvec3 ab = glm::dvec3(b.x, b.y, b.w) - origin;
  const glm::dvec3 ac = glm::dvec3(c.x, c.y, c.w) - origin;
  return glm::dot(origin, glm::cross(ab, ac));
}

/// Whether a model matrix turns counter-clockwise triangles into clockwise ones: det of its linear part < 0.
inline bool is_mirroring(const glm::dmat4& world_from_object) {
  const glm::dvec3 x(world_from_object[0]), y(world_from_object[1]), z(world_from_object[2]);
  return glm::dot(x, glm::cross(y, z)) < 0.0;
}

/// The facing of a triangle from its homogeneous determinant; a mirrored instance flips it.
constexpr Facing facing_of(double determinant, bool mirrored) {
  const bool is_back = mirrored ? determinant > 0.0 : determinant < 0.0;
  return is_back ? Facing::back : Facing::front;
}

/// The one formula for all projections, π·e: positive if the viewer `eye` (see eye_of()) stands on the
/// plane's positive side, 0 if the plane is seen edge-on. Both of the lecture's readings below reduce to it.
inline double side_of_viewer(const Plane& plane, const glm::dvec4& eye) {
  return glm::dot(plane.homogeneous(), eye);
}

/// The lecture's first reading (line of sight): a polygon faces away if the line of sight and its normal
/// enclose less than 90°, LOS·n > 0. LOS runs from the COP to a point of the plane; it is the DOP in parallel
/// projections.
/// @param eye      (COP, 1) or (-DOP, 0)
/// @param on_plane any point of the plane
inline double line_of_sight_test(const Plane& plane, const glm::dvec3& on_plane, const glm::dvec4& eye) {
  const glm::dvec3 line_of_sight = on_plane * eye.w - glm::dvec3(eye);
  return glm::dot(line_of_sight, plane.normal);
}

/// The lecture's second reading (half-space): a polygon faces away if the COP lies in its negative
/// half-space, n·COP + D < 0. @param cop  finite: perspective only
inline double half_space_test(const Plane& plane, const glm::dvec3& cop) {
  return plane.signed_value(cop);
}

}  // namespace velum
