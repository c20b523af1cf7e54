#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "surface_rows.hpp"
#include "triangle_view.hpp"

namespace velum {

/// A triangle as the vector kernels read it.
/// @param colours  of the vertices: the triangle's own, or lit ones (Gouraud)
TrianglePlanes planes_of(const TriangleView& triangle, const std::array<glm::vec4, 3>& colours);

}  // namespace velum
