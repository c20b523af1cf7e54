#include "frame.hpp"

#include <cmath>

#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "checks.hpp"
#include "extreme_points.hpp"
#include "framing.hpp"

namespace velum {
namespace {

[[noreturn]] void refuse(const std::string& problem, const std::string& where, const std::string& remedy) {
  throw Error(ErrorKind::usage, problem, where, remedy);
}

void check_numbers(const FrameOptions& o) {
  check_positive(o.aspect, "aspect");
  if (!(o.margin >= 0.0 && o.margin < 0.5)) {
    refuse("margin is " + text_of(o.margin), "margin", "it must be at least 0 and less than 0.5");
  }
  if (o.eye) check_finite(*o.eye, "eye");
  if (o.target) check_finite(*o.target, "target");
  if (o.up) check_direction(*o.up, "up");
  if (o.vertical_angle) check_opening_angle(*o.vertical_angle, "vertical opening angle");
  if (o.horizontal_angle) check_opening_angle(*o.horizontal_angle, "horizontal opening angle");
  if (o.near) check_finite(*o.near, "near");
  if (o.far) check_finite(*o.far, "far");
}

void check_options(const FrameOptions& o, ProjectionFamily family) {
  check_numbers(o);
  if (o.vertical_angle && o.horizontal_angle) {
    refuse("both the vertical and the horizontal opening angle are given", "opening angle",
           "one follows from the other and the aspect; give one");
  }
  if (o.near && o.far && !(*o.near < *o.far)) {
    refuse("near " + text_of(*o.near) + " is not smaller than far " + text_of(*o.far), "near",
           "choose near < far");
  }
  if (o.eye && o.target && *o.eye == *o.target) {
    refuse("eye and target are the same point " + text_of(*o.eye), "target", "move one of them");
  }
  if (family == ProjectionFamily::perspective) {
    if (o.near) check_positive(*o.near, "near");
    if (o.far) check_positive(*o.far, "far");
  } else if (o.vertical_angle || o.horizontal_angle) {
    refuse("a parallel projection has no opening angle", "opening angle",
           "leave it out, or choose a perspective projection");
  }
}

double largest_component(const glm::dvec3& v) {
  const glm::dvec3 a = glm::abs(v);
  return glm::max(a.x, glm::max(a.y, a.z));
}

// The box to frame: an empty one becomes a unit cube; one so small that double cannot tell its corners apart
// grows around its centre.
Aabb box_to_frame(const Aabb& bounds) {
  if (bounds.is_empty()) return {glm::dvec3(-0.5), glm::dvec3(0.5)};
  const double reach = glm::max(largest_component(bounds.lower), largest_component(bounds.upper));
  if (!(reach <= 1e60))
    refuse("the scene's coordinates reach " + text_of(reach), "bounds", "keep below 1e60");
  if (largest_component(bounds.size()) > glm::max(1e-9 * reach, 1e-60)) return bounds;
  const glm::dvec3 half(0.5 * glm::max(1e-3, 1e-6 * reach));
  return {bounds.centre() - half, bounds.centre() + half};
}

// The catalogue's directions are for a world with y up; this is the quarter turn to one with z up.
glm::dvec3 turned(const glm::dvec3& v, bool z_up) {
  return z_up ? glm::dvec3(v.x, -v.z, v.y) : v;
}

Projection turned(Projection projection, bool z_up) {
  projection.look = turned(projection.look, z_up);
  projection.up = turned(projection.up, z_up);
  projection.to_eye = turned(projection.to_eye, z_up);
  return projection;
}

glm::dvec3 nearest_axis(const glm::dvec3& v) {
  const glm::dvec3 a = glm::abs(v);
  if (a.x > a.y && a.x > a.z) return {v.x < 0.0 ? -1.0 : 1.0, 0.0, 0.0};
  if (a.y > a.z) return {0.0, v.y < 0.0 ? -1.0 : 1.0, 0.0};
  return {0.0, 0.0, v.z < 0.0 ? -1.0 : 1.0};
}

// Where the camera looks. A user's eye looks at the target or the box's centre; one- and two-point
// perspective keep their vanishing points by looking along the nearest axis, respectively horizontally.
glm::dvec3 look_direction(const Framing& f) {
  if (!f.options.eye) return f.projection.look;
  const glm::dvec3 aim = f.focus - *f.options.eye;
  if (aim == glm::dvec3(0.0)) return f.projection.look;
  if (f.projection.vanishing_points == 1) return nearest_axis(aim);
  if (f.projection.vanishing_points != 2) return aim;
  glm::dvec3 level = aim;
  (f.options.z_up ? level.z : level.y) = 0.0;
  return level == glm::dvec3(0.0) ? f.projection.look : level;
}

// The user's up; else, of a camera that a user aimed, the world's up, or what a plan has there.
glm::dvec3 up_direction(const Framing& f, const glm::dvec3& look) {
  if (f.options.up) return *f.options.up;
  if (!f.options.eye) return f.projection.up;
  const glm::dvec3 world_up = turned({0.0, 1.0, 0.0}, f.options.z_up);
  if (!are_parallel(look, world_up)) return world_up;
  if (!are_parallel(look, f.projection.up)) return f.projection.up;
  return turned({0.0, 0.0, glm::dot(look, world_up) < 0.0 ? -1.0 : 1.0}, f.options.z_up);
}

double span_from(double start, double size) {
  return glm::max(size, std::abs(start));
}

}  // namespace

Points Framing::outline_from(const glm::dvec3& origin) const {
  Points points = outline;
  for (glm::dvec3& point : points) point = axes.camera_from_world(point - origin);
  return points;
}

Range depths(const Points& points) {
  Range range{-points[0].z, -points[0].z};
  for (const glm::dvec3& point : points) {
    range.lower = glm::min(range.lower, -point.z);
    range.upper = glm::max(range.upper, -point.z);
  }
  return range;
}

Range near_and_far(const Framing& framing, const Range& depth, double least_share) {
  const FrameOptions& o = framing.options;
  const double extent = glm::max(depth.upper - depth.lower, 0.1 * framing.size);
  const double pad = glm::max(1e-3 * extent, 1e-12 * std::abs(depth.upper));
  const bool visible = depth.upper > 0.0;
  const double farthest = visible ? depth.upper + pad : framing.size;
  const double least = least_share * farthest;
  Range range{visible ? glm::max(depth.lower - pad, least) : least, farthest};
  if (o.near) range.lower = *o.near;
  if (o.far) range.upper = *o.far;
  if (range.lower < range.upper) return range;
  // One of the two is the user's, and all of the box lies on its other side.
  if (o.near) {
    range.upper = range.lower + span_from(range.lower, framing.size);
  } else if (least_share > 0.0) {
    range.lower = least_share * range.upper;
  } else {
    range.lower = range.upper - span_from(range.upper, framing.size);
  }
  return range;
}

namespace {

Framing framing_of(const Aabb& bounds, const Projection& projection, const FrameOptions& options) {
  check_options(options, projection.family);
  Framing framing;
  framing.options = options;
  framing.projection = turned(projection, options.z_up);
  framing.box = box_to_frame(bounds);
  framing.size = largest_component(framing.box.size());
  framing.focus = options.target.value_or(framing.box.centre());
  const glm::dvec3 look = look_direction(framing);
  framing.axes = camera_axes(look, up_direction(framing, look));
  const auto corners = framing.box.corners();
  framing.outline.assign(corners.begin(), corners.end());
  return framing;
}

Camera framed(const Framing& framing) {
  const bool perspective = framing.projection.family == ProjectionFamily::perspective;
  return perspective ? frame_perspective(framing) : frame_parallel(framing);
}

}  // namespace

Camera frame(const Aabb& bounds, const Projection& projection, const FrameOptions& options) {
  const FloatingPointScope floating_point;
  return framed(framing_of(bounds, projection, options));
}

Camera frame(std::span<const glm::dvec3> points, const Projection& projection, const FrameOptions& options) {
  const FloatingPointScope floating_point;
  std::vector<glm::dvec3> finite;
  Aabb bounds;
  for (const glm::dvec3& point : points) {
    if (!is_finite(point)) continue;
    finite.push_back(point);
    bounds.include(point);
  }
  Framing framing = framing_of(bounds, projection, options);
  // A box that had to be made larger to have an extent at all keeps its corners.
  const bool has_extent =
      !finite.empty() && framing.box.lower == bounds.lower && framing.box.upper == bounds.upper;
  if (has_extent) framing.outline = extreme_points(finite, framing.axes, framing.box.centre());
  return framed(framing);
}

}  // namespace velum
