#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace velum::shapes {

/// Corners on the unit sphere and faces as corner indices, counter-clockwise seen from outside.
struct Polyhedron {
  std::vector<glm::dvec3> corners;
  std::vector<std::vector<std::uint32_t>> faces;
};

Polyhedron unit_icosahedron();

}  // namespace velum::shapes
