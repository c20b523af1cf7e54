#include <cmath>
#include <glm/matrix.hpp>

#include "../base/elementary.hpp"
#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "camera.hpp"
#include "camera_axes.hpp"
#include "checks.hpp"

// The factors of the composite viewing matrix, one function each, named as in the lecture "Projektionen und
// Sichtbarkeit" (after van Dam 2001). The last section of this file puts them in order.

namespace velum {
namespace {

// Written as on paper: the arguments are the rows.
glm::dmat4 from_rows(const glm::dvec4& x, const glm::dvec4& y, const glm::dvec4& z, const glm::dvec4& w) {
  return glm::transpose(glm::dmat4(x, y, z, w));
}

glm::dmat4 scaling(double x, double y, double z) {
  return from_rows({x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}, {0, 0, 0, 1});
}

glm::dmat4 translation(const glm::dvec3& t) {
  return from_rows({1, 0, 0, t.x}, {0, 1, 0, t.y}, {0, 0, 1, t.z}, {0, 0, 0, 1});
}

Stage to_eye_point(const Pose& pose) {
  return {"T(-COP)", "Moves the camera's position to the origin.",
          translation(glm::dvec3(0.0) - pose.position)};
}

Stage to_camera_axes(const Pose& pose) {
  const CameraAxes axes = camera_axes(pose.look, pose.up);
  return {"M_rot^T", "Turns the world until the camera looks down its own -z with +y up.",
          from_rows({axes.right, 0}, {axes.up, 0}, {axes.back, 0}, {0, 0, 0, 1})};
}

Stage lens_shear(const glm::dvec2& centre) {
  return {"Sh_lens", "Shears the line from the eye to the middle of the picture window onto the -z axis.",
          from_rows({1, 0, centre.x, 0}, {0, 1, centre.y, 0}, {0, 0, 1, 0}, {0, 0, 0, 1})};
}

Stage to_right_angle(const glm::dvec2& half_slope) {
  return {"S_xy", "Scales x and y so that the sides of the pyramid of view have slope 1.",
          scaling(1.0 / half_slope.x, 1.0 / half_slope.y, 1.0)};
}

Stage to_unit_depth(double far) {
  return {"S_xyz(1/far)", "Scales everything so that the far plane lies at z = -1.",
          scaling(1.0 / far, 1.0 / far, 1.0 / far)};
}

Stage unhinge(double near, double far) {
  const double k = near / far;
  return {
      "D",
      "Opens the pyramid of view into a box, which makes nearer things larger: near to z = 0, far to z = 1.",
      from_rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1.0 / (k - 1.0), k / (k - 1.0)}, {0, 0, -1, 0})};
}

Stage oblique_shear(const ParallelWindow& window) {
  const glm::dvec2 s = window.shear;
  return {"Sh_oblique",
          "Shears slanting projectors upright; the plane at the focus distance keeps place and size.",
          from_rows({1, 0, s.x, s.x * window.focus}, {0, 1, s.y, s.y * window.focus}, {0, 0, 1, 0},
                    {0, 0, 0, 1})};
}

Stage near_to_zero(double near) {
  return {"T(0,0,near)", "Moves the near plane to z = 0.", translation({0, 0, near})};
}

Stage window_to_unit(double width, double height, double depth) {
  return {"S(2/w,2/h,1/(far-near))",
          "Scales the window to -1 ... 1 in x and y, and the depth range to length 1.",
          scaling(2.0 / width, 2.0 / height, 1.0 / depth)};
}

Stage mirror() {
  return {"S(1,1,-1)", "Mirrors z, so that depth grows away from the viewer: near at z = 0, far at z = 1.",
          scaling(1.0, 1.0, -1.0)};
}

// Half the window's width and height at distance 1 from the eye.
glm::dvec2 half_slope_of(const Opening& opening, double aspect) {
  if (const auto* horizontal = std::get_if<HorizontalAngle>(&opening)) {
    const double slope = elementary::tan(0.5 * horizontal->radians);
    return {slope, slope / aspect};
  }
  if (const auto* focal = std::get_if<FocalLength>(&opening)) {
    const double slope = focal->film_height / (2.0 * focal->focal_length);
    return {slope * aspect, slope};
  }
  const double slope = elementary::tan(0.5 * std::get<VerticalAngle>(opening).radians);
  return {slope * aspect, slope};
}

// D · S_xyz(1/far) · S_xy · [Sh_lens] · M_rotᵀ · T(-COP); `centre` is the slope of the window's middle.
StageList perspective_stages(const Camera& camera, const glm::dvec2& half_slope, const glm::dvec2& centre) {
  StageList stages{to_eye_point(camera.pose()), to_camera_axes(camera.pose())};
  if (centre != glm::dvec2(0.0)) stages.push_back(lens_shear(centre));
  stages.push_back(to_right_angle(half_slope));
  stages.push_back(to_unit_depth(camera.far()));
  stages.push_back(unhinge(camera.near(), camera.far()));
  return stages;
}

StageList stages_of(const Camera& camera, const PerspectiveLens& lens, double aspect) {
  const glm::dvec2 half_slope = half_slope_of(lens.opening, aspect);
  return perspective_stages(camera, half_slope, 2.0 * lens.shift * half_slope);
}

StageList stages_of(const Camera& camera, const OffAxisFrustum& f, double) {
  const double twice_near = 2.0 * camera.near();
  return perspective_stages(camera, {(f.right - f.left) / twice_near, (f.top - f.bottom) / twice_near},
                            {(f.right + f.left) / twice_near, (f.top + f.bottom) / twice_near});
}

// S(1,1,-1) · S(2/w,2/h,1/(far-near)) · T(0,0,near) · [Sh_oblique] · M_rotᵀ · T(-COP)
StageList stages_of(const Camera& camera, const ParallelWindow& window, double aspect) {
  StageList stages{to_eye_point(camera.pose()), to_camera_axes(camera.pose())};
  if (window.shear != glm::dvec2(0.0)) stages.push_back(oblique_shear(window));
  stages.push_back(near_to_zero(camera.near()));
  stages.push_back(window_to_unit(window.height * aspect, window.height, camera.far() - camera.near()));
  stages.push_back(mirror());
  return stages;
}

// The embedder's own matrix, then what takes its clip space to ours.
StageList stages_of(const Camera&, const ClipMatrix& matrix, double) {
  StageList stages{
      {"clip matrix", "The caller's own matrix, from world to its clip space.", matrix.clip_from_world}};
  if (matrix.range == DepthRange::minus_one_to_one) {
    stages.push_back({"depth range", "Takes depth from -1 ... 1 to 0 ... 1.",
                      from_rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0.5, 0.5}, {0, 0, 0, 1})});
  } else if (matrix.range == DepthRange::one_to_zero) {
    stages.push_back({"depth range", "Reverses depth, from 1 near ... 0 far to 0 near ... 1 far.",
                      from_rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, 1}, {0, 0, 0, 1})});
  }
  if (matrix.y == ClipY::down) {
    stages.push_back({"y flip", "Turns y from down to up.", scaling(1.0, -1.0, 1.0)});
  }
  return stages;
}

void check_picture_aspect(double picture, std::optional<double> own, double tolerance) {
  check_positive(picture, "picture aspect");
  if (own && std::abs(picture - *own) > tolerance * *own) {
    throw Error(ErrorKind::usage,
                "the camera's aspect is " + text_of(*own) + ", the picture's is " + text_of(picture),
                "aspect", "render a picture of the camera's aspect, or make the camera without one");
  }
}

// A window or a depth range of extreme size may leave the range of double.
void check_stage(const Stage& stage, const Camera& camera) {
  const double determinant = glm::determinant(stage.matrix);
  if (is_regular(stage.matrix) && determinant != 0.0 && std::isfinite(determinant)) return;
  throw Error(ErrorKind::usage,
              "numbers so large, small or different make the stage " + std::string(stage.name) +
                  " of the viewing matrix singular (near " + text_of(camera.near()) + ", far " +
                  text_of(camera.far()) + ")",
              "camera", "keep near, far, opening angle, and the camera's distance to a usual size");
}

}  // namespace

ViewingTransform Camera::viewing_transform(double picture_aspect, double tolerance) const {
  const FloatingPointScope floating_point;
  check_picture_aspect(picture_aspect, aspect_, tolerance);
  StageList stages =
      std::visit([&](const auto& lens) { return stages_of(*this, lens, picture_aspect); }, lens_);
  for (const Stage& stage : stages) check_stage(stage, *this);
  return ViewingTransform(stages);
}

}  // namespace velum
