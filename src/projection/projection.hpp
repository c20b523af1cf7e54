#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "../base/elementary.hpp"

namespace velum {

enum class ProjectionFamily { orthographic, oblique, axonometry, perspective };

/// A way of projecting, independent of what is projected: directions and shape, no position. frame() makes a
/// Camera of it. Directions are in a y-up world; Scene::up turns them.
struct Projection {
  std::string name;
  ProjectionFamily family = ProjectionFamily::orthographic;
  glm::dvec3 look{0.0, 0.0, -1.0};   ///< look direction, unit length
  glm::dvec3 up{0.0, 1.0, 0.0};      ///< the picture's up, unit length, perpendicular to look
  glm::dvec3 to_eye{0.0, 0.0, 1.0};  ///< perspective: direction from the scene to the COP; differs from -look
                                     ///< for one-point and two-point, where lens shift reframes
  glm::dvec2 shear{0.0};             ///< oblique: (-L·cosφ, -L·sinφ)
  double vertical_angle = radians(40.0);  ///< perspective: opening angle in radians, in (0, π)
  /// Perspective: 1 or 2: so many model axes keep a finite vanishing point wherever a user puts the eye;
  /// frame() then shifts the lens instead of turning the camera. 0: free.
  int vanishing_points = 0;
};

/// The catalogue. Angles in radians. Sources: ISO 5456-2, 5456-3; Pohlke 1853; the lecture "Projektionen und
/// Sichtbarkeit".
/// @throws Error (usage) for parameters out of range
namespace projection {

Projection front();
Projection back();
Projection left();
Projection right();
Projection top();
Projection bottom();
/// Any orthographic view: elevation and azimuth of the direction *to* the camera, (sin a·cos e, sin e, cos
/// a·cos e).
Projection orthographic(double elevation, double azimuth);
Projection isometric();
Projection dimetric();
Projection dimetric_2to1();
Projection trimetric(double elevation = radians(35.0), double azimuth = radians(30.0));
/// Pohlke: the pictures of the three model axes have these angles (counter-clockwise from the picture's
/// right) and scales (≥ 0). Seen from the side from which the three pictures form a right-handed system, so
/// front faces stay front. The standard look has x to the right, y up, z to the lower left (e.g. 222°).
Projection axonometry(const std::array<double, 3>& angles, const std::array<double, 3>& scales);
/// A receding axis is drawn at angle φ with scale L; projectors meet the picture plane at α = atan(1/L).
Projection oblique(double angle = radians(45.0), double scale = 0.5);
Projection cavalier(double angle = radians(45.0), double scale = 1.0);
Projection cabinet(double angle = radians(45.0), double scale = 0.5);
Projection natural_oblique(double angle = radians(45.0), double scale = 2.0 / 3.0);
/// Planometric: the camera looks straight down, the plan is turned so that the side at azimuth `turn` comes
/// to the bottom, heights are drawn up.
Projection military(double turn = radians(45.0), double scale = 1.0);
Projection perspective(double vertical_angle = radians(40.0), double elevation = radians(20.0),
                       double azimuth = radians(30.0));
Projection one_point(double vertical_angle = radians(40.0), double elevation = radians(20.0),
                     double azimuth = radians(25.0));
Projection two_point(double vertical_angle = radians(40.0), double elevation = radians(20.0),
                     double azimuth = radians(35.0));
Projection three_point(double vertical_angle = radians(40.0), double elevation = radians(30.0),
                       double azimuth = radians(35.0));

}  // namespace projection

/// A row of the catalogue, for `velum projections` and for parsing.
struct ProjectionEntry {
  struct Parameter {
    std::string_view name;  ///< as on the command line
    std::string_view unit;  ///< "degrees" or "ratio"
    double default_value;   ///< in that unit
    std::string_view meaning;
  };
  std::string_view name;     ///< as on the command line
  std::string_view family;   ///< "orthographic", "oblique", "axonometry" or "perspective"
  std::string_view summary;  ///< one sentence
  std::string_view source;
  std::vector<Parameter> parameters;
};

/// Every projection that has a name, orthographic ones first, then oblique, then perspective.
const std::vector<ProjectionEntry>& projection_catalogue();

/// "NAME" or "NAME:key=value,key=value"; angles in degrees, e.g. "oblique:angle=45,scale=0.5",
/// "trimetric:elevation=35,azimuth=30", "axonometry:x=-7,y=90,z=222,sx=1,sy=1,sz=0.5".
/// @throws Error (usage) naming the part that is not understood and what is
Projection parse_projection(std::string_view text);

}  // namespace velum
