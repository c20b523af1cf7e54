#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "surface_rows.hpp"
#include "triangle_view.hpp"

namespace velum {

/// A triangle as the vector kernels read it.
/// @param colours  of the vertices: the triangle's own, or lit ones (Gouraud)
/// @param highlights  of lit colours, the parts that no texture colours; nullptr: none
TrianglePlanes planes_of(const TriangleView& triangle, const std::array<glm::vec4, 3>& colours,
                         const std::array<glm::vec3, 3>* highlights = nullptr);

}  // namespace velum
