#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "../base/aabb.hpp"
#include "camera.hpp"
#include "projection.hpp"

namespace velum {

/// What framing must respect. Everything not given is chosen so that the box fills the picture with the
/// margin.
struct FrameOptions {
  double aspect = 1.0;   ///< width / height of the picture, > 0
  double margin = 0.05;  ///< empty share at each side of the picture, 0 ≤ margin < 0.5
  bool z_up = false;     ///< the world's z axis points up: the projection's directions turn with it
  std::optional<glm::dvec3> eye{};
  std::optional<glm::dvec3> target{};
  std::optional<glm::dvec3> up{};
  std::optional<double> vertical_angle{};    ///< radians; at most one of the two angles
  std::optional<double> horizontal_angle{};  ///< radians
  std::optional<double> near{};
  std::optional<double> far{};
};

/// Places a camera so that the box fills the picture with a margin, and chooses near and far tightly, for
/// every projection. An empty box is framed as a unit cube around the origin, a point as a small box around
/// it.
///
/// Without an eye: the projection's direction; the camera chooses its distance so that the box touches the
/// margin (with a target, the target is the picture's middle; one- and two-point perspective shift the lens
/// instead). With an eye: it looks at the target, or at the box's centre; its opening angle, unless given,
/// just holds the box, or is 60 degrees if the eye is inside it or would need more than 100. One-point
/// perspective then looks along the axis nearest to that direction and two-point perspective horizontally,
/// and the lens is shifted. What lies behind an eye is not seen; a box wholly behind it still gives a valid
/// camera, with a blank picture.
/// @throws Error (usage) for options that cannot be met, naming them
Camera frame(const Aabb& bounds, const Projection& projection, const FrameOptions& options = {});

/// The same around points instead of a box: tighter, since a box's corners are seldom part of what it holds.
/// Points that are not finite are left out. Scene::points() gives a scene's.
Camera frame(std::span<const glm::dvec3> points, const Projection& projection,
             const FrameOptions& options = {});

}  // namespace velum
