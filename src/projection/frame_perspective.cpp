#include <cmath>
#include <limits>
#include <optional>

#include "../base/elementary.hpp"
#include "framing.hpp"

namespace velum {
namespace {

constexpr double default_angle = radians(60.0);
constexpr double widest_slope = 1.1917535925942099;  // tan 50°: pictures wider than 100° look strained
constexpr double nearest_share = 1e-4;               // smallest near, as a share of far
constexpr double clearance = 0.01;                   // smallest distance to the box, as a share of its size

// Slopes are x / depth and y / depth seen from the eye: where a point lies in the picture.
Range slopes(const Points& points, const glm::dvec3& eye, int axis) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const glm::dvec3& point : points) {
    const double slope = (point[axis] - eye[axis]) / (eye.z - point.z);
    range.lower = glm::min(range.lower, slope);
    range.upper = glm::max(range.upper, slope);
  }
  return range;
}

// How the picture's x (0) or y (1) is brought to hold the box when the camera chooses its own distance.
struct AxisFit {
  double half_slope;                // of the window, margin taken off
  std::optional<double> eye_slope;  // lens shift: the eye stays on this line, x = slope·z; the window moves
  // No shift: the eye moves aside, to between x = plus - t·z and x = t·z - minus, which meet at the least z.
  double plus = 0.0, minus = 0.0;
  bool keep_centre = false;  // or stays in front of the target

  double least() const { return (keep_centre ? glm::max(plus, minus) : 0.5 * (plus + minus)) / half_slope; }
};

// |x - x_eye| ≤ t·(z_eye - z) for all points: two lines bound the eye.
AxisFit centred_fit(const Points& points, int axis, double half_slope, bool keep_centre) {
  AxisFit fit{half_slope,
              {},
              -std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity(),
              keep_centre};
  for (const glm::dvec3& point : points) {
    fit.plus = glm::max(fit.plus, point[axis] + half_slope * point.z);
    fit.minus = glm::max(fit.minus, -point[axis] + half_slope * point.z);
  }
  return fit;
}

// The eye's x at distance z, chosen so that the box's picture has as much room on one side as on the other:
// by halving, for as the eye moves right every slope falls.
double eye_offset(const Points& points, int axis, const AxisFit& fit, double z) {
  if (fit.eye_slope) return *fit.eye_slope * z;
  if (fit.keep_centre) return 0.0;
  double left = fit.plus - fit.half_slope * z;
  double right = fit.half_slope * z - fit.minus;
  while (true) {
    const double middle = left + 0.5 * (right - left);
    if (!(left < middle && middle < right)) return middle;
    glm::dvec3 eye(0.0, 0.0, z);
    eye[axis] = middle;
    const Range range = slopes(points, eye, axis);
    const double balance = range.lower + range.upper;
    if (balance == 0.0) return middle;
    (balance > 0.0 ? left : right) = middle;
  }
}

glm::dvec3 eye_at(const Points& points, const std::array<AxisFit, 2>& fits, double z) {
  return {eye_offset(points, 0, fits[0], z), eye_offset(points, 1, fits[1], z), z};
}

bool window_holds(const Points& points, const std::array<AxisFit, 2>& fits, double z) {
  for (int axis = 0; axis < 2; ++axis) {
    const AxisFit& fit = fits[static_cast<std::size_t>(axis)];
    if (!fit.eye_slope) continue;
    glm::dvec3 eye(0.0, 0.0, z);
    eye[axis] = *fit.eye_slope * z;
    const Range range = slopes(points, eye, axis);
    if (range.upper - range.lower > 2.0 * fit.half_slope) return false;
  }
  return true;
}

// The nearest z from which a window moved by lens shift holds the box: the box's picture only shrinks with
// distance, so the place is bracketed and halved until double has no number between.
double nearest_fit(const Points& points, const std::array<AxisFit, 2>& fits, double least, double step) {
  if (window_holds(points, fits, least)) return least;
  double outside = least;
  double inside = least + step;
  for (; !window_holds(points, fits, inside) && step < 1e300; step *= 2.0) {
    outside = inside;
    inside += step;
  }
  while (true) {
    const double middle = outside + 0.5 * (inside - outside);
    if (!(outside < middle && middle < inside)) return inside;
    (window_holds(points, fits, middle) ? inside : outside) = middle;
  }
}

Opening opening_of(const Framing& f) {
  if (f.options.horizontal_angle) return HorizontalAngle{*f.options.horizontal_angle};
  return VerticalAngle{f.options.vertical_angle.value_or(f.projection.vertical_angle)};
}

// Half the window's width and height at distance 1 from the eye.
glm::dvec2 half_slope_of(const Opening& opening, double aspect) {
  if (const auto* horizontal = std::get_if<HorizontalAngle>(&opening)) {
    const double slope = elementary::tan(0.5 * horizontal->radians);
    return {slope, slope / aspect};
  }
  const double slope = elementary::tan(0.5 * std::get<VerticalAngle>(opening).radians);
  return {slope * aspect, slope};
}

Camera camera_at(const Framing& f, const glm::dvec3& position, const Points& from_eye, const Opening& opening,
                 const glm::dvec2& shift) {
  const Range range = near_and_far(f, depths(from_eye), nearest_share);
  return Camera::perspective(f.pose_at(position), {opening, shift}, range.lower, range.upper);
}

// The camera chooses its place.
Camera frame_freely(const Framing& f) {
  const Opening opening = opening_of(f);
  const glm::dvec2 half_slope = half_slope_of(opening, f.options.aspect);
  const Points points = f.outline_from(f.focus);
  const glm::dvec3 to_eye = f.axes.camera_from_world(f.projection.to_eye);
  const bool keep_centre = f.options.target.has_value();

  std::array<AxisFit, 2> fits{};
  double least = clearance * f.size - depths(points).lower;
  for (int axis = 0; axis < 2; ++axis) {
    AxisFit& fit = fits[static_cast<std::size_t>(axis)];
    const double usable = half_slope[axis] * f.usable();
    // Only one- and two-point perspective have their eye beside the look vector.
    if (f.projection.vanishing_points != 0 && std::abs(to_eye[axis]) > 1e-9 * to_eye.z) {
      fit = {usable, to_eye[axis] / to_eye.z};
    } else {
      fit = centred_fit(points, axis, usable, keep_centre);
      least = glm::max(least, fit.least());
    }
  }
  const glm::dvec3 eye = eye_at(points, fits, nearest_fit(points, fits, least, f.size));

  glm::dvec2 shift(0.0);
  for (int axis = 0; axis < 2; ++axis) {
    if (!fits[static_cast<std::size_t>(axis)].eye_slope) continue;
    const Range range = slopes(points, eye, axis);
    shift[axis] = 0.25 * (range.lower + range.upper) / half_slope[axis];
  }
  const glm::dvec3 position = f.focus + f.axes.world_from_camera(eye);
  return camera_at(f, position, f.outline_from(position), opening, shift);
}

// Where a user's eye has the middle of its picture: on the look vector, except that one-point (x and y) and
// two-point perspective (y) shift the lens to the target, or to the middle of the box.
glm::dvec2 middle_slope(const Framing& f, const Points& from_eye) {
  const int count = f.projection.vanishing_points;
  glm::dvec2 middle(0.0);
  if (count == 0) return middle;
  const glm::dvec3 aim = f.axes.camera_from_world(f.focus - *f.options.eye);
  const bool in_front = depths(from_eye).lower > 0.0;
  for (int axis = count == 1 ? 0 : 1; axis < 2; ++axis) {
    if (in_front && !f.options.target) {
      const Range range = slopes(from_eye, glm::dvec3(0.0), axis);
      middle[axis] = 0.5 * (range.lower + range.upper);
    } else if (aim.z < 0.0) {
      middle[axis] = aim[axis] / -aim.z;
    }
  }
  return middle;
}

// The opening angle that holds the box seen from a user's eye, if that is not too wide.
Opening fitting_opening(const Framing& f, const Points& from_eye, const glm::dvec2& middle) {
  const Range depth = depths(from_eye);
  if (!(depth.lower > 0.0)) return VerticalAngle{default_angle};
  glm::dvec2 reach(0.0);
  for (int axis = 0; axis < 2; ++axis) {
    const Range range = slopes(from_eye, glm::dvec3(0.0), axis);
    reach[axis] = glm::max(range.upper - middle[axis], middle[axis] - range.lower);
  }
  const double needed = glm::max(reach.y, reach.x / f.options.aspect) / f.usable();
  const double slope = glm::max(needed, 1e-3 * f.size / depth.upper);  // a line seen from its end needs none
  if (!(glm::max(slope, slope * f.options.aspect) <= widest_slope)) return VerticalAngle{default_angle};
  return VerticalAngle{2.0 * elementary::atan(slope)};
}

Camera frame_from_eye(const Framing& f) {
  const glm::dvec3 position = *f.options.eye;
  const Points from_eye = f.outline_from(position);
  const glm::dvec2 middle = middle_slope(f, from_eye);
  const bool chosen = f.options.vertical_angle || f.options.horizontal_angle;
  const Opening opening = chosen ? opening_of(f) : fitting_opening(f, from_eye, middle);
  const glm::dvec2 half_slope = half_slope_of(opening, f.options.aspect);
  return camera_at(f, position, from_eye, opening, 0.5 * middle / half_slope);
}

}  // namespace

Camera frame_perspective(const Framing& framing) {
  return framing.options.eye ? frame_from_eye(framing) : frame_freely(framing);
}

}  // namespace velum
