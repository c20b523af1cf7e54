#include "plane_projection.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "../base/error.hpp"
#include "checks.hpp"

namespace velum {
namespace {

// Written as on paper: the arguments are the rows.
glm::dmat4 from_rows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z, const glm::dvec4& w) {
  return glm::transpose(glm::dmat4(x, y, z, w));
}

void check_distance(double d) {
  if (!std::isfinite(d) || d == 0.0) {
    throw Error(ErrorKind::usage, "the distance of the centre of projection is " + text_of(d), "d",
                "it must be finite and not 0");
  }
}

}  // namespace

glm::dmat4 project_onto_plane(const glm::dvec4& plane, const glm::dvec4& centre) {
  const double incidence = glm::dot(plane, centre);
  const glm::dvec4 magnitudes = glm::abs(plane * centre);
  const double rounding = 4e-16 * (magnitudes.x + magnitudes.y + magnitudes.z + magnitudes.w);
  if (!std::isfinite(incidence) || std::abs(incidence) <= rounding) {
    throw Error(ErrorKind::usage, "the centre of projection lies in the picture plane, or is not finite",
                "project_onto_plane");
  }
  return glm::dmat4(incidence) - glm::outerProduct(centre, plane);
}

glm::dmat4 project_onto_x(double x0) {
  check_finite(x0, "x0");
  return from_rows({0, 0, 0, x0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
}

glm::dmat4 project_onto_y(double y0) {
  check_finite(y0, "y0");
  return from_rows({1, 0, 0, 0}, {0, 0, 0, y0}, {0, 0, 1, 0}, {0, 0, 0, 1});
}

glm::dmat4 project_onto_z(double z0) {
  check_finite(z0, "z0");
  return from_rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, z0}, {0, 0, 0, 1});
}

glm::dmat4 oblique_onto_xy(const glm::dvec3& r) {
  check_finite(r, "r");
  if (r.z == 0.0) {
    throw Error(ErrorKind::usage, "the projectors " + text_of(r) + " run parallel to the xy plane", "r",
                "r.z must not be 0");
  }
  return from_rows({1, 0, -r.x / r.z, 0}, {0, 1, -r.y / r.z, 0}, {0, 0, 0, 0}, {0, 0, 0, 1});
}

glm::dmat4 central_onto_xy(double d) {
  check_distance(d);
  return from_rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0, 0, 1.0 / d, 1});
}

glm::dmat4 central_onto_xy_times_d(double d) {
  check_distance(d);
  return from_rows({d, 0, 0, 0}, {0, d, 0, 0}, {0, 0, 0, 0}, {0, 0, 1, d});
}

}  // namespace velum
