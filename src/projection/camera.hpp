#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <variant>

#include "../base/floating_point.hpp"
#include "viewing_transform.hpp"

namespace velum {

/// Where the camera stands and how it is turned. World space.
struct Pose {
  glm::dvec3 position{0.0};  ///< centre of projection; for parallel projections a point on the camera plane
  glm::dvec3 look{0.0, 0.0, -1.0};  ///< look direction; need not be unit length
  glm::dvec3 up{0.0, 1.0, 0.0};     ///< roughly up; must not be parallel to look

  static Pose towards(const glm::dvec3& position, const glm::dvec3& target,
                      const glm::dvec3& up = {0.0, 1.0, 0.0}) {
    const FloatingPointScope floating_point;
    return {position, target - position, up};
  }
};

/// The vertical opening angle, radians, in (0, π).
struct VerticalAngle {
  double radians;
};
/// The horizontal opening angle, radians, in (0, π).
struct HorizontalAngle {
  double radians;
};
/// Focal length and film height, in the same unit.
struct FocalLength {
  double focal_length;
  double film_height;
};
using Opening = std::variant<VerticalAngle, HorizontalAngle, FocalLength>;

/// A perspective lens. The lens shift moves the picture window by shift · (window width, window height):
/// shift.x = 0.5 puts the principal point on the left edge.
struct PerspectiveLens {
  Opening opening = VerticalAngle{0.78539816339744831};
  glm::dvec2 shift{0.0};
};

/// An off-axis frustum: the window's edges on the near plane, camera space (as glFrustum).
struct OffAxisFrustum {
  double left, right, bottom, top;
};

/// A parallel projection: a window of `height` world units (its width follows from the aspect), and the
/// oblique shear x' = x + shear.x·(z + focus), y' = y + shear.y·(z + focus) in camera space; shear 0 is
/// orthographic.
struct ParallelWindow {
  double height = 2.0;
  glm::dvec2 shear{0.0};  ///< (-L·cosφ, -L·sinφ) for a receding axis drawn at angle φ with scale L
  double focus = 0.0;     ///< distance along the look vector of the plane that keeps place and size
};

/// The depth range and the direction of y of an embedder's clip space.
enum class DepthRange { zero_to_one, minus_one_to_one, one_to_zero };
enum class ClipY { up, down };

struct ClipMatrix {
  glm::dmat4 clip_from_world{1.0};
  DepthRange range = DepthRange::minus_one_to_one;
  ClipY y = ClipY::up;
};

/// The largest far / near of a perspective camera. After D, z and w of what is far away differ by near / far
/// of themselves, and double keeps 16 digits of each: with more than this fewer than four would be left of
/// what they differ by, which is depth, and what says on which side of the far plane a point lies. (A clip
/// matrix whose far plane is at infinity loses depth in the same way at distances above near times this.)
inline constexpr double largest_far_over_near = 1e12;

/// The largest distance of the near and the far plane of a parallel camera, in heights of its window. Beyond,
/// all that a window can show lies within 10^-10 of the depth range, less than float32 can tell apart; and a
/// ray that starts on so distant a near plane would miss its pixel.
inline constexpr double largest_depth_in_windows = 1e10;

/// A camera: a pose, a lens or window, near and far, and optionally an aspect of its own.
/// The camera looks down its own -z, its up is +y. Checked when made: a Camera that exists can be used.
/// Source of the parameters: the lecture "Projektionen und Sichtbarkeit", after van Dam 2001.
class Camera {
 public:
  using Lens = std::variant<PerspectiveLens, OffAxisFrustum, ParallelWindow, ClipMatrix>;

  /// @param near, far  distances along the look vector, 0 < near < far (parallel: near < far, any sign)
  /// @param aspect     width / height of the picture; absent: that of the picture being rendered
  /// @throws Error (usage) naming the parameter: up parallel to look, near ≥ far, zero sizes, angles out of
  /// range, values that are not finite; perspective and off_axis: far / near >
  /// largest_far_over_near; parallel: near or far more than largest_depth_in_windows·height away
  static Camera perspective(const Pose& pose, const PerspectiveLens& lens, double near, double far,
                            std::optional<double> aspect = {});
  static Camera off_axis(const Pose& pose, const OffAxisFrustum& frustum, double near, double far);
  static Camera parallel(const Pose& pose, const ParallelWindow& window, double near, double far,
                         std::optional<double> aspect = {});
  /// An embedder's own matrix, with its depth range: OpenGL (minus_one_to_one), Direct3D and Vulkan
  /// (zero_to_one), reversed z (one_to_zero). @throws Error (usage) if it is singular or not finite
  static Camera from_clip_matrix(const glm::dmat4& clip_from_world, DepthRange range, ClipY y = ClipY::up);

  /// As given; of a clip matrix, read off it: perspective: at the eye, across the plane w = 0; parallel: on
  /// the near plane, across it.
  const Pose& pose() const { return pose_; }
  const Lens& lens() const { return lens_; }
  /// Distances along the look vector; of a clip matrix, along the axis of pose(), perhaps infinite.
  double near() const { return near_; }
  double far() const { return far_; }
  /// The aspect that the camera insists on, if any.
  std::optional<double> aspect() const { return aspect_; }
  bool is_perspective() const;

  /// The composite viewing matrix as named stages.
  /// @param picture_aspect  width / height of the picture
  /// Stages that would be the identity (no lens shift, no shear, the depth range already 0 … 1) are left out.
  /// @throws Error (usage) if the camera has an aspect of its own that differs by more than tolerance
  /// (relative)
  ViewingTransform viewing_transform(double picture_aspect, double tolerance = 1e-9) const;

 private:
  Camera() = default;
  Camera(const Pose& pose, const Lens& lens, double near, double far, std::optional<double> aspect);

  Pose pose_;
  Lens lens_;
  double near_ = 0.0;
  double far_ = 1.0;
  std::optional<double> aspect_;
};

/// Distance of a world point from the camera plane along the look vector, in world units, as (a, b, c, d)·(x,
/// y, z, 1). For every projection, oblique too. Of a clip matrix: perspective: the plane w = 0 is the camera
/// plane; parallel: the near plane is.
glm::dvec4 metric_depth_plane(const Camera& camera);

}  // namespace velum
