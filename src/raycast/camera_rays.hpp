#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "../base/ray.hpp"
#include "../projection/viewing_transform.hpp"
#include "../projection/viewport.hpp"
#include "intersection/interval.hpp"

namespace velum {

/// A ray and the part of it that is in the view volume, from the near plane to the far plane.
struct ViewRay {
  Ray ray;
  Interval range;
};

/// The rays of a camera, whatever its projection: the lines that the inverse of the composite viewing matrix
/// makes of the lines along z in the canonical view volume. World space, in double.
///
/// The inverse's columns are computed as the points where planes meet, in a space with the camera in its
/// origin. Of the whole inverse as one matrix, two columns are the eye times far/near, and the direction of a
/// ray is the little in which they differ: for far/near above 10^11 nothing would be left of it.
///
/// (The lecture "Raytracing" steps across the picture plane from 2·(x/xres - 1/2), through the pixels'
/// corners and with one axis for both sums; velum's pixels have their centres at +1/2.)
class CameraRays {
 public:
  /// @pre no stage is singular, as Camera sees to
  CameraRays(const ViewingTransform& viewing, const Viewport& viewport);

  /// The ray through a place on the picture, pixels, y down. Usually t runs from 0 on the near plane to 1 on
  /// the far plane. A far plane at infinity, or behind it, has t = infinity and the unit of t is arbitrary.
  ViewRay through(double px, double py) const;

 private:
  /// Homogeneous points, camera-centred, of one plane as the ndc say: p = columns · (x, y, 1).
  using PlanePoints = std::array<glm::dvec4, 3>;
  static glm::dvec4 point_at(const PlanePoints& columns, const glm::dvec2& ndc);

  PlanePoints near_{};
  PlanePoints far_{};
  glm::dvec3 centre_{0.0};  ///< the origin of camera-centred space, in the world
  Viewport viewport_;
};

}  // namespace velum
