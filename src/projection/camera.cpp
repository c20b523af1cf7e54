#include "camera.hpp"

#include <algorithm>
#include <cmath>

#include "../base/elementary.hpp"
#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "camera_axes.hpp"
#include "checks.hpp"

namespace velum {
namespace {

void check_opening(const Opening& opening) {
  if (const auto* vertical = std::get_if<VerticalAngle>(&opening)) {
    check_opening_angle(vertical->radians, "vertical opening angle");
  } else if (const auto* horizontal = std::get_if<HorizontalAngle>(&opening)) {
    check_opening_angle(horizontal->radians, "horizontal opening angle");
  } else {
    const auto& focal = std::get<FocalLength>(opening);
    check_positive(focal.focal_length, "focal length");
    check_positive(focal.film_height, "film height");
  }
}

void check_near_far(double near, double far, bool perspective) {
  check_finite(near, "near");
  check_finite(far, "far");
  if (perspective) check_positive(near, "near");
  if (!(near < far)) {
    throw Error(ErrorKind::usage, "near " + text_of(near) + " is not smaller than far " + text_of(far),
                "near", "choose near < far");
  }
  check_finite(far - near, "far - near");
}

[[noreturn]] void refuse_range(const std::string& reason, double near, double far,
                               const std::string& advice) {
  throw Error(ErrorKind::usage, reason + " (near " + text_of(near) + ", far " + text_of(far) + ")", "near",
              advice);
}

/// @pre 0 < near < far, finite
void check_far_over_near(double near, double far) {
  // Decimal numbers that stand in the very ratio may be read as ones in the next larger.
  if (!(far / near > largest_far_over_near * (1.0 + 0x1p-50))) return;
  refuse_range("far / near is more than " + text_of(largest_far_over_near) + ", which leaves depth no digits",
               near, far, "choose a larger near or a smaller far");
}

/// @pre near < far, finite; window_height > 0
void check_depth_in_windows(double near, double far, double window_height) {
  const double farthest = std::max(std::fabs(near), std::fabs(far));
  if (!(farthest / window_height > largest_depth_in_windows)) return;
  refuse_range("near or far is more than " + text_of(largest_depth_in_windows) +
                   " times the window's height " + text_of(window_height) +
                   " away, which leaves depth no digits",
               near, far, "choose near and far closer to the scene");
}

void check_ordered(double lower, double upper, const char* lower_name, const char* upper_name) {
  check_finite(lower, lower_name);
  check_finite(upper, upper_name);
  if (!(lower < upper)) {
    throw Error(ErrorKind::usage,
                std::string(lower_name) + " " + text_of(lower) + " is not smaller than " + upper_name + " " +
                    text_of(upper),
                lower_name, "the window needs a size");
  }
  check_finite(upper - lower, std::string(upper_name) + " - " + lower_name);
}

glm::dvec4 row(const glm::dmat4& matrix, int index) {
  return {matrix[0][index], matrix[1][index], matrix[2][index], matrix[3][index]};
}

struct PoseAndRange {
  Pose pose;
  double near, far;
};

// Distances along the look vector at which canonical z is 0 and 1; infinite where the matrix has it so.
PoseAndRange with_range(const glm::dmat4& clip, const Pose& pose) {
  const glm::dvec4 origin(pose.position, 1.0);
  const glm::dvec4 along(pose.look, 0.0);
  const glm::dvec4 z = row(clip, 2);
  const glm::dvec4 beyond = z - row(clip, 3);
  return {pose, -glm::dot(z, origin) / glm::dot(z, along),
          -glm::dot(beyond, origin) / glm::dot(beyond, along)};
}

// What a clip matrix says about where its camera stands. Perspective: at the eye, looking across the plane
// w = 0. Parallel: on the near plane, looking across it.
PoseAndRange read_off(const glm::dmat4& clip) {
  const glm::dvec4 eye = eye_of(clip);
  const glm::dvec4 w = row(clip, 3);
  const glm::dvec3 up(row(clip, 1));
  if (eye.w != 0.0) return with_range(clip, {glm::dvec3(eye), unit(glm::dvec3(w)), up});
  const glm::dvec4 z = row(clip, 2);
  const double side = w.w < 0.0 ? -1.0 : 1.0;
  const glm::dvec3 normal(z);
  const glm::dvec3 on_near = normal * (-z.w / glm::dot(normal, normal));
  return with_range(clip, {on_near, unit(normal * side), up});
}

}  // namespace

Camera Camera::perspective(const Pose& pose, const PerspectiveLens& lens, double near, double far,
                           std::optional<double> aspect) {
  const FloatingPointScope floating_point;
  check_opening(lens.opening);
  check_finite(lens.shift, "lens shift");
  check_near_far(near, far, true);
  check_far_over_near(near, far);
  if (aspect) check_positive(*aspect, "aspect");
  return Camera(pose, lens, near, far, aspect);
}

Camera Camera::off_axis(const Pose& pose, const OffAxisFrustum& frustum, double near, double far) {
  const FloatingPointScope floating_point;
  check_ordered(frustum.left, frustum.right, "left", "right");
  check_ordered(frustum.bottom, frustum.top, "bottom", "top");
  check_near_far(near, far, true);
  check_far_over_near(near, far);
  const double aspect = (frustum.right - frustum.left) / (frustum.top - frustum.bottom);
  return Camera(pose, frustum, near, far, aspect);
}

Camera Camera::parallel(const Pose& pose, const ParallelWindow& window, double near, double far,
                        std::optional<double> aspect) {
  const FloatingPointScope floating_point;
  check_positive(window.height, "window height");
  check_finite(window.shear, "shear");
  check_finite(window.focus, "focus");
  check_near_far(near, far, false);
  check_depth_in_windows(near, far, window.height);
  if (aspect) check_positive(*aspect, "aspect");
  return Camera(pose, window, near, far, aspect);
}

Camera Camera::from_clip_matrix(const glm::dmat4& clip_from_world, DepthRange range, ClipY y) {
  const FloatingPointScope floating_point;
  check_regular(clip_from_world, "clip matrix");
  Camera camera;
  camera.lens_ = ClipMatrix{clip_from_world, range, y};
  const PoseAndRange read = read_off(camera.viewing_transform(1.0).clip_from_world());
  camera.pose_ = read.pose;
  camera.near_ = read.near;
  camera.far_ = read.far;
  return camera;
}

Camera::Camera(const Pose& pose, const Lens& lens, double near, double far, std::optional<double> aspect)
    : pose_(pose), lens_(lens), near_(near), far_(far), aspect_(aspect) {
  check_finite(pose.position, "position");
  camera_axes(pose.look, pose.up);
  viewing_transform(aspect_.value_or(1.0));
}

bool Camera::is_perspective() const {
  if (const auto* matrix = std::get_if<ClipMatrix>(&lens_)) {
    return glm::dvec3(row(matrix->clip_from_world, 3)) != glm::dvec3(0.0);
  }
  return !std::holds_alternative<ParallelWindow>(lens_);
}

glm::dvec4 metric_depth_plane(const Camera& camera) {
  const FloatingPointScope floating_point;
  const auto* matrix = std::get_if<ClipMatrix>(&camera.lens());
  if (matrix == nullptr) {
    const glm::dvec3 look = unit(camera.pose().look);
    return {look, -glm::dot(look, camera.pose().position)};
  }
  const glm::dmat4 clip = camera.viewing_transform(1.0).clip_from_world();
  const glm::dvec4 w = row(clip, 3);
  const glm::dvec4 plane = camera.is_perspective() ? w : row(clip, 2) * (w.w < 0.0 ? -1.0 : 1.0);
  return plane / glm::length(glm::dvec3(plane));
}

}  // namespace velum
