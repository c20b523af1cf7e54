#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "camera_axes.hpp"
#include "frame.hpp"

// What frame() prepares once for both families of projection; private to frame*.cpp.

namespace velum {

/// Points in camera axes (x right, y up, z towards the viewer).
using Points = std::vector<glm::dvec3>;

struct Framing {
  FrameOptions options;
  Projection projection;  ///< its directions turned into the world's axes
  Aabb box;               ///< never empty, never a point
  std::vector<glm::dvec3>
      outline;        ///< world points that must fit: the box's corners, or the scene's extreme points
  double size = 1.0;  ///< the box's longest edge
  glm::dvec3 focus;   ///< the target, or the box's centre
  CameraAxes axes;

  /// The outline in camera axes, relative to a world point.
  Points outline_from(const glm::dvec3& origin) const;
  /// The share of half the picture that the box may take: 1 - 2·margin.
  double usable() const { return 1.0 - 2.0 * options.margin; }
  Pose pose_at(const glm::dvec3& position) const { return {position, -axes.back, axes.up}; }
};

struct Range {
  double lower, upper;
};

/// Depth range of points relative to the camera: distances along the look vector.
Range depths(const Points& points);

/// Near and far: the user's, or tight around `depth` with a pad so that faces of the box are not cut, and
/// nothing behind the camera. A box wholly behind gets a valid range all the same.
/// @param least_share  near is at least this share of the far depth (0 for parallel projections)
Range near_and_far(const Framing& framing, const Range& depth, double least_share);

Camera frame_parallel(const Framing& framing);
Camera frame_perspective(const Framing& framing);

}  // namespace velum
