#pragma once

#include <glm/mat4x4.hpp>

#include "../base/ray.hpp"
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
/// (The lecture "Raytracing" steps across the picture plane from 2·(x/xres - 1/2), through the pixels'
/// corners and with one axis for both sums; velum's pixels have their centres at +1/2.)
class CameraRays {
 public:
  /// @param world_from_clip  see ViewingTransform::world_from_clip()
  CameraRays(const glm::dmat4& world_from_clip, const Viewport& viewport)
      : world_from_clip_(world_from_clip), viewport_(viewport) {}

  /// The ray through a place on the picture, pixels, y down. Usually t runs from 0 on the near plane to 1 on
  /// the far plane. A far plane at infinity, or behind it, has t = infinity and the unit of t is arbitrary.
  ViewRay through(double px, double py) const;

 private:
  glm::dmat4 world_from_clip_;
  Viewport viewport_;
};

}  // namespace velum
