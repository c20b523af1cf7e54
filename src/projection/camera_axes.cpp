#include "camera_axes.hpp"

#include <cmath>

#include "../base/error.hpp"
#include "checks.hpp"

namespace velum {
namespace {

constexpr double smallest_sine = 1e-9;

// -0 becomes +0, so that matrices print alike whichever way a zero came about.
glm::dvec3 without_negative_zero(const glm::dvec3& v) {
  return v + glm::dvec3(0.0);
}

}  // namespace

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::dvec3 unit(const glm::dvec3& v) {
  const double largest = glm::max(glm::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
  const glm::dvec3 scaled = v / largest;
  return scaled / std::sqrt(glm::dot(scaled, scaled));
}

bool are_parallel(const glm::dvec3& a, const glm::dvec3& b) {
  if (a == glm::dvec3(0.0) || b == glm::dvec3(0.0)) return true;
  const glm::dvec3 normal = glm::cross(unit(a), unit(b));
  return glm::dot(normal, normal) <= smallest_sine * smallest_sine;
}

CameraAxes camera_axes(const glm::dvec3& look, const glm::dvec3& up) {
  check_direction(look, "look");
  check_direction(up, "up");
  if (are_parallel(look, up)) {
    throw Error(ErrorKind::usage, "up " + text_of(up) + " is parallel to the look direction " + text_of(look),
                "up", "give an up vector that points to another side");
  }
  const glm::dvec3 back = unit(-look);
  const glm::dvec3 side = unit(glm::cross(unit(up), back));
  // Twice around: if up is close to look, `side` alone is perpendicular to look only to a few digits.
  const glm::dvec3 true_up = unit(glm::cross(back, side));
  const glm::dvec3 right = glm::cross(true_up, back);
  return {without_negative_zero(right), without_negative_zero(true_up), without_negative_zero(back)};
}

}  // namespace velum
