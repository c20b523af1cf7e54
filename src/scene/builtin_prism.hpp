#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "builtin_surface.hpp"

namespace velum::shapes {

/// An outline, counter-clockwise seen from its front, given depth along `out()`.
struct Prism {
  glm::dvec3 right{1.0, 0.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  std::vector<glm::dvec2> outline;    ///< along right and up
  std::vector<glm::uvec3> triangles;  ///< of the front, over the outline's corners
  double back = 0.0;                  ///< along out
  double front = 0.0;                 ///< along out, > back

  glm::dvec3 out() const { return glm::cross(right, up); }
  glm::dvec3 at(const glm::dvec2& corner, double depth) const {
    return right * corner.x + up * corner.y + out() * depth;
  }
};

void add_front(SurfaceBuilder& builder, const Prism& prism);
void add_back(SurfaceBuilder& builder, const Prism& prism);
/// One rectangle for each edge of the outline.
void add_sides(SurfaceBuilder& builder, const Prism& prism);
/// All three: a closed solid.
void add_prism(SurfaceBuilder& builder, const Prism& prism);

/// The closed box between two corners, 12 triangles, every face with the whole texture.
void add_box(SurfaceBuilder& builder, const glm::dvec3& lower, const glm::dvec3& upper);

}  // namespace velum::shapes
