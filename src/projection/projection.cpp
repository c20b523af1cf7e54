#include "projection.hpp"

#include <cmath>
#include <utility>

#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "checks.hpp"

namespace velum::projection {
namespace {

using elementary::cos;
using elementary::sin;

// Sine and cosine of a view's elevation and azimuth: exact views are given by these, not by their angles.
struct Direction {
  double sin_elevation, cos_elevation, sin_azimuth, cos_azimuth;

  glm::dvec3 to_camera() const {
    return {sin_azimuth * cos_elevation, sin_elevation, cos_azimuth * cos_elevation};
  }
  glm::dvec3 up() const {
    return {-sin_azimuth * sin_elevation, cos_elevation, -cos_azimuth * sin_elevation};
  }
};

void check_range(double angle, double limit, const std::string& name) {
  check_finite(angle, name);
  if (!(std::abs(angle) <= limit + 1e-12)) {  // degrees turned into radians may land an ulp beyond
    throw Error(ErrorKind::usage, name + " is " + text_of(degrees(angle)) + " degrees", name,
                "it must be between " + text_of(degrees(-limit)) + " and " + text_of(degrees(limit)));
  }
}

Direction direction(double elevation, double azimuth) {
  check_range(elevation, 0.5 * pi, "elevation");
  check_range(azimuth, 2.0 * pi, "azimuth");
  return {sin(elevation), cos(elevation), sin(azimuth), cos(azimuth)};
}

Projection view_from(const char* name, const Direction& d, ProjectionFamily family) {
  Projection result;
  result.name = name;
  result.family = family;
  result.look = -d.to_camera();
  result.up = d.up();
  result.to_eye = d.to_camera();
  return result;
}

Projection principal(const char* name, const glm::dvec3& look, const glm::dvec3& up) {
  Projection result;
  result.name = name;
  result.look = look;
  result.up = up;
  result.to_eye = -look;
  return result;
}

// A receding axis at angle φ with scale L, on a front face seen from +z.
Projection receding(const char* name, double angle, double scale) {
  const FloatingPointScope floating_point;
  check_range(angle, 2.0 * pi, "angle");
  check_finite(scale, "scale");
  if (scale < 0.0) {
    throw Error(ErrorKind::usage, "scale is " + text_of(scale), "scale",
                "it must not be negative; turn the angle by 180 degrees instead");
  }
  Projection result;
  result.name = name;
  result.family = ProjectionFamily::oblique;
  result.shear = {-scale * cos(angle), -scale * sin(angle)};
  return result;
}

Projection perspective_from(const char* name, double vertical_angle, const Direction& d) {
  check_opening_angle(vertical_angle, "fov");
  Projection result = view_from(name, d, ProjectionFamily::perspective);
  result.vertical_angle = vertical_angle;
  return result;
}

// A view that is to have a given number of vanishing points needs its directions off the model axes by this
// much (sine of the angle).
constexpr double clearly_nonzero = 1e-6;

void demand(bool condition, const std::string& name, const std::string& problem, const std::string& remedy) {
  if (!condition) throw Error(ErrorKind::usage, problem, name, remedy);
}

}  // namespace

Projection front() {
  return principal("front", {0, 0, -1}, {0, 1, 0});
}
Projection back() {
  return principal("back", {0, 0, 1}, {0, 1, 0});
}
Projection left() {
  return principal("left", {1, 0, 0}, {0, 1, 0});
}
Projection right() {
  return principal("right", {-1, 0, 0}, {0, 1, 0});
}
Projection top() {
  return principal("top", {0, -1, 0}, {0, 0, -1});
}
Projection bottom() {
  return principal("bottom", {0, 1, 0}, {0, 0, 1});
}

Projection orthographic(double elevation, double azimuth) {
  const FloatingPointScope floating_point;
  return view_from("orthographic", direction(elevation, azimuth), ProjectionFamily::orthographic);
}

Projection isometric() {
  const FloatingPointScope floating_point;
  // Along the diagonal of the cube: elevation asin(1/√3), azimuth 45°.
  const double half = std::sqrt(0.5);
  return view_from("isometric", {1.0 / std::sqrt(3.0), std::sqrt(2.0 / 3.0), half, half},
                   ProjectionFamily::orthographic);
}

Projection dimetric() {
  const FloatingPointScope floating_point;
  // Scales 1 : ½ : 1 exactly: elevation asin(1/3), azimuth atan(1/√7).
  return view_from("dimetric", {1.0 / 3.0, std::sqrt(8.0) / 3.0, std::sqrt(0.125), std::sqrt(0.875)},
                   ProjectionFamily::orthographic);
}

Projection dimetric_2to1() {
  const FloatingPointScope floating_point;
  // Elevation 30°, azimuth 45°: both ground axes fall by one pixel in two.
  const double half = std::sqrt(0.5);
  return view_from("dimetric-2to1", {0.5, std::sqrt(0.75), half, half}, ProjectionFamily::orthographic);
}

Projection trimetric(double elevation, double azimuth) {
  const FloatingPointScope floating_point;
  return view_from("trimetric", direction(elevation, azimuth), ProjectionFamily::orthographic);
}

Projection oblique(double angle, double scale) {
  return receding("oblique", angle, scale);
}
Projection cavalier(double angle, double scale) {
  return receding("cavalier", angle, scale);
}
Projection cabinet(double angle, double scale) {
  return receding("cabinet", angle, scale);
}
Projection natural_oblique(double angle, double scale) {
  return receding("natural-oblique", angle, scale);
}

Projection military(double turn, double scale) {
  const FloatingPointScope floating_point;
  check_range(turn, 2.0 * pi, "turn");
  // The plan as seen from straight above by a viewer who came from azimuth `turn`; φ = 270°, so that heights,
  // which come towards the viewer, are drawn up.
  Projection result = receding("military", 0.0, scale);
  result.look = {0, -1, 0};
  result.to_eye = {0, 1, 0};
  result.up = {-sin(turn), 0.0, -cos(turn)};
  result.shear = {0.0, scale};
  return result;
}

Projection perspective(double vertical_angle, double elevation, double azimuth) {
  const FloatingPointScope floating_point;
  return perspective_from("perspective", vertical_angle, direction(elevation, azimuth));
}

Projection one_point(double vertical_angle, double elevation, double azimuth) {
  const FloatingPointScope floating_point;
  Projection result = perspective_from("one-point", vertical_angle, direction(elevation, azimuth));
  demand(result.to_eye.z > 0.01, "one-point", "the eye would not stand in front of the picture plane",
         "keep elevation and azimuth between -89 and 89 degrees");
  result.look = {0, 0, -1};
  result.up = {0, 1, 0};
  result.vanishing_points = 1;
  return result;
}

Projection two_point(double vertical_angle, double elevation, double azimuth) {
  const FloatingPointScope floating_point;
  const Direction d = direction(elevation, azimuth);
  Projection result = perspective_from("two-point", vertical_angle, d);
  demand(d.cos_elevation > 0.01, "two-point", "the eye would not stand in front of the picture plane",
         "keep the elevation between -89 and 89 degrees");
  demand(std::abs(d.sin_azimuth) > clearly_nonzero && std::abs(d.cos_azimuth) > clearly_nonzero, "two-point",
         "at this azimuth a face is parallel to the picture, and only one vanishing point is finite",
         "turn the azimuth away from multiples of 90 degrees, or use one-point");
  result.look = {-d.sin_azimuth, 0.0, -d.cos_azimuth};
  result.up = {0, 1, 0};
  result.vanishing_points = 2;
  return result;
}

Projection three_point(double vertical_angle, double elevation, double azimuth) {
  const FloatingPointScope floating_point;
  Projection result = perspective_from("three-point", vertical_angle, direction(elevation, azimuth));
  const glm::dvec3 slant = glm::abs(result.look);
  demand(glm::min(slant.x, glm::min(slant.y, slant.z)) > clearly_nonzero, "three-point",
         "a model axis is parallel to the picture, so fewer than three vanishing points are finite",
         "turn elevation and azimuth away from multiples of 90 degrees, or use one-point or two-point");
  return result;
}

}  // namespace velum::projection
