#include "builtin_prism.hpp"

#include <glm/common.hpp>

namespace velum::shapes {
namespace {

/// The unit square, counter-clockwise from the lower left.
constexpr glm::dvec2 k_square[4] = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};

/// The outline at one depth; the texture fills the outline's box, upright seen from outside.
std::uint32_t add_outline(SurfaceBuilder& builder, const Prism& prism, double depth, double facing) {
  glm::dvec2 lower = prism.outline[0];
  glm::dvec2 upper = lower;
  for (const glm::dvec2& corner : prism.outline) {
    lower = glm::min(lower, corner);
    upper = glm::max(upper, corner);
  }
  std::uint32_t last = 0;
  for (const glm::dvec2& corner : prism.outline) {
    glm::dvec2 uv = (corner - lower) / (upper - lower);
    if (facing < 0.0) uv.x = 1.0 - uv.x;
    last = builder.vertex({prism.at(corner, depth), prism.out() * facing, uv});
  }
  return last + 1 - static_cast<std::uint32_t>(prism.outline.size());
}

}  // namespace

void add_front(SurfaceBuilder& builder, const Prism& prism) {
  const std::uint32_t first = add_outline(builder, prism, prism.front, 1.0);
  for (const glm::uvec3& t : prism.triangles) builder.triangle(first + t.x, first + t.y, first + t.z);
}

void add_back(SurfaceBuilder& builder, const Prism& prism) {
  const std::uint32_t first = add_outline(builder, prism, prism.back, -1.0);
  for (const glm::uvec3& t : prism.triangles) builder.triangle(first + t.x, first + t.z, first + t.y);
}

void add_sides(SurfaceBuilder& builder, const Prism& prism) {
  for (std::size_t i = 0; i < prism.outline.size(); ++i) {
    const glm::dvec2& from = prism.outline[i];
    const glm::dvec2& to = prism.outline[(i + 1) % prism.outline.size()];
    const glm::dvec3 corners[4] = {prism.at(from, prism.front), prism.at(from, prism.back),
                                   prism.at(to, prism.back), prism.at(to, prism.front)};
    builder.flat_polygon(corners, k_square);
  }
}

void add_prism(SurfaceBuilder& builder, const Prism& prism) {
  add_front(builder, prism);
  add_back(builder, prism);
  add_sides(builder, prism);
}

void add_box(SurfaceBuilder& builder, const glm::dvec3& lower, const glm::dvec3& upper) {
  // What is right and up on each face, seen from outside: front, back, left, right, top, bottom.
  constexpr glm::dvec3 axes[6][2] = {{{1, 0, 0}, {0, 1, 0}},  {{-1, 0, 0}, {0, 1, 0}},
                                     {{0, 0, 1}, {0, 1, 0}},  {{0, 0, -1}, {0, 1, 0}},
                                     {{1, 0, 0}, {0, 0, -1}}, {{1, 0, 0}, {0, 0, 1}}};
  for (const auto& [right, up] : axes) {
    const glm::dvec3 out = glm::cross(right, up);
    glm::dvec3 corners[4];
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 side = right * (2.0 * k_square[i].x - 1.0) + up * (2.0 * k_square[i].y - 1.0) + out;
      corners[i] = glm::mix(lower, upper, glm::greaterThan(side, glm::dvec3(0.0)));
    }
    builder.flat_polygon(corners, k_square);
  }
}

}  // namespace velum::shapes
