#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <optional>

#include "../base/aabb.hpp"
#include "../projection/viewport.hpp"
#include "canvas.hpp"

namespace velum {

/// The corners of a box with a place in the world, numbered as Aabb::corners() numbers them.
std::array<glm::dvec4, 8> placed_corners(const Aabb& box, const glm::dmat4& world_from_object);

/// A canvas on which boxes of the world are drawn, as a camera sees them.
class BoxView {
 public:
  BoxView(const glm::dmat4& clip_from_world, int width, int height)
      : clip_from_world_(clip_from_world),
        viewport_{width, height},
        canvas_(width, height, {255, 255, 255, 255}) {}

  /// Where a point is seen, pixels; nothing for one beside or behind the eye.
  std::optional<glm::dvec2> place(const glm::dvec4& world) const;
  void line(const glm::dvec4& a, const glm::dvec4& b, double thickness, const Rgba8& colour);
  void dashed_line(const glm::dvec4& a, const glm::dvec4& b, double thickness, const Rgba8& colour);
  /// The twelve edges of a box.
  void edges(const std::array<glm::dvec4, 8>& world, double thickness, const Rgba8& colour);
  Canvas& canvas() { return canvas_; }

 private:
  glm::dmat4 clip_from_world_;
  Viewport viewport_;
  Canvas canvas_;
};

}  // namespace velum
