#include "box_view.hpp"

namespace velum {

std::array<glm::dvec4, 8> placed_corners(const Aabb& box, const glm::dmat4& world_from_object) {
  const std::array<glm::dvec3, 8> corners = box.corners();
  std::array<glm::dvec4, 8> placed;
  for (std::size_t i = 0; i < 8; ++i) placed[i] = world_from_object * glm::dvec4(corners[i], 1.0);
  return placed;
}

std::optional<glm::dvec2> BoxView::place(const glm::dvec4& world) const {
  const glm::dvec4 clip = clip_from_world_ * world;
  if (!(clip.w > 0.0)) return {};
  return viewport_.pixel_from_ndc(clip.x / clip.w, clip.y / clip.w);
}

void BoxView::line(const glm::dvec4& a, const glm::dvec4& b, double thickness, const Rgba8& colour) {
  const auto from = place(a), to = place(b);
  if (from && to) canvas_.line(*from, *to, thickness, colour);
}

void BoxView::dashed_line(const glm::dvec4& a, const glm::dvec4& b, double thickness, const Rgba8& colour) {
  const auto from = place(a), to = place(b);
  if (from && to) canvas_.dashed_line(*from, *to, thickness, 6.0, colour);
}

void BoxView::edges(const std::array<glm::dvec4, 8>& world, double thickness, const Rgba8& colour) {
  for (unsigned i = 0; i < 8; ++i) {
    for (unsigned axis = 1; axis < 8; axis *= 2) {
      if ((i & axis) == 0) line(world[i], world[i | axis], thickness, colour);
    }
  }
}

}  // namespace velum
