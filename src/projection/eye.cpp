#include <cmath>

#include "../base/error.hpp"
#include "camera_axes.hpp"
#include "kernel.hpp"
#include "viewing_transform.hpp"

namespace velum {
glm::dvec4 eye_of(const glm::dmat4& clip_from_world) {
  const glm::dvec4 w = row(clip_from_world, 3);
  const glm::dvec4 eye = kernel(row(clip_from_world, 0), row(clip_from_world, 1), w);
  if (eye.w != 0.0 && std::isfinite(eye.w)) {
    return {eye.x / eye.w, eye.y / eye.w, eye.z / eye.w, 1.0};
  }
  const glm::dvec3 direction(eye);
  if (!is_finite(direction) || direction == glm::dvec3(0.0)) {
    throw Error(ErrorKind::usage, "rows x, y, w of the matrix are dependent, so it has no eye", "matrix");
  }
  // All projectors are parallel; towards the viewer the canonical depth z / w falls.
  const glm::dvec3 towards = unit(direction);
  const double slope = glm::dot(glm::dvec3(row(clip_from_world, 2)), towards) * w.w;
  return {slope > 0.0 ? -towards : towards, 0.0};
}

}  // namespace velum
