#include <cmath>

#include "checks.hpp"
#include "framing.hpp"

namespace velum {
namespace {

// Height of the window, centred on the picture of the focus, that holds the sheared box with the margin.
double window_height(const Framing& framing, const Points& points, const glm::dvec2& shear) {
  glm::dvec2 reach(0.0);
  for (const glm::dvec3& point : points) {
    reach = glm::max(reach, glm::abs(glm::dvec2(point) + shear * point.z));
  }
  const double needed = glm::max(reach.y, reach.x / framing.options.aspect);
  // A line seen from its end has no picture to fit.
  const double half = needed > 1e-9 * framing.size ? needed : 0.5 * framing.size;
  return 2.0 * half / framing.usable();
}

}  // namespace

Camera frame_parallel(const Framing& framing) {
  const glm::dvec2 shear = framing.projection.shear;
  check_finite(shear, "shear");
  const Points around_focus = framing.outline_from(framing.focus);
  const Range from_focus = depths(around_focus);
  // Far enough back that the nearest point is one box size in front.
  const double distance = glm::max(framing.size - from_focus.lower, 0.0);
  const glm::dvec3 position = framing.options.eye.value_or(framing.focus + framing.axes.back * distance);
  const double focus =
      framing.options.eye ? -framing.axes.camera_from_world(framing.focus - position).z : distance;
  const Range range = near_and_far(framing, {from_focus.lower + focus, from_focus.upper + focus}, 0.0);
  return Camera::parallel(framing.pose_at(position),
                          {window_height(framing, around_focus, shear), shear, focus}, range.lower,
                          range.upper);
}

}  // namespace velum
