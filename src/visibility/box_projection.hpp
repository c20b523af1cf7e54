#pragma once

#include <array>
#include <glm/mat4x4.hpp>

#include "../base/aabb.hpp"
#include "../base/rect.hpp"
#include "../projection/viewing_transform.hpp"
#include "../projection/viewport.hpp"
#include "../spatial/oriented_box.hpp"

namespace velum {

/// What may be seen of triangles whose vertices all lie in a box: bounds on the safe side.
struct BoxOnPicture {
  bool is_outside = false;  ///< beyond one plane of the view volume: nothing of them is drawn
  Rect pixels;              ///< no pixel elsewhere is covered; may be empty, and may reach one pixel beyond
                            ///< the picture
  float nearest = 1.0f;     ///< no fragment has a larger reversed depth
};

/// Brings boxes to the picture: the rectangle around their corners, grown by one snapping step (1/256 pixel),
/// and the depth of their nearest corner. Both hold for the unsnapped, unclipped triangles within, in exact
/// arithmetic, and are then widened by more than all roundings on the way of a vertex can amount to. A box
/// that reaches the eye's plane has no bounds: the whole picture, and depth 1.
class BoxProjection {
 public:
  /// @param within  a box around all those that will be asked about: the roundings are estimated for it
  BoxProjection(const glm::dmat4& clip_from_object, const Viewport& viewport, const Aabb& within);

  /// For boxes in world space around vertices that are transformed by other matrices, their own
  /// clip_from_object: then the roundings are those of all products of the stages.
  /// @param within  a box around the world boxes, and around all sums |matrix|·|position| that lead there
  BoxProjection(const ViewingTransform& clip_from_world, const Viewport& viewport, const Aabb& within);

  BoxOnPicture operator()(const Aabb& box) const;
  BoxOnPicture operator()(const OrientedBox& box) const;

  /// The matrix it was made with.
  const glm::dmat4& clip_from_object() const { return clip_from_object_; }
  /// How far a computed clip coordinate (x, y, z, w) of a vertex may be from the exact one.
  const glm::dvec4& rounding() const { return rounding_; }

 private:
  struct Corners;
  void estimate_rounding(const glm::dmat4& magnitudes, const Aabb& within);
  bool is_outside(const Corners& corners) const;
  BoxOnPicture judge(const Corners& corners) const;
  BoxOnPicture bounds_of(const Corners& corners, double smallest_w) const;

  glm::dmat4 clip_from_object_;
  Viewport viewport_;
  glm::dvec4 rounding_;
};

}  // namespace velum
