#include "builtin_polyhedra.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "../base/floating_point.hpp"
#include "builtin.hpp"
#include "builtin_parameters.hpp"
#include "builtin_surface.hpp"

namespace velum::shapes {
namespace {

constexpr double golden_ratio = 1.61803398874989484820;  // (1 + √5)/2

/// All corners are equally far from the origin; they move onto the unit sphere.
std::vector<glm::dvec3> on_unit_sphere(std::vector<glm::dvec3> corners) {
  const double length = std::sqrt(glm::dot(corners[0], corners[0]));
  for (glm::dvec3& corner : corners) corner /= length;
  return corners;
}

Polyhedron unit_tetrahedron() {
  // Every second corner of a cube.
  return {on_unit_sphere({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}),
          {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
}

Polyhedron unit_octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {0, 5, 2}, {0, 4, 3}, {0, 3, 5}, {1, 4, 2}, {1, 2, 5}, {1, 3, 4}, {1, 5, 3}}};
}

/// The corners of a cube and of three golden rectangles (Coxeter, "Regular Polytopes", 1948, §3.7).
Polyhedron unit_dodecahedron() {
  const double a = golden_ratio;
  const double b = 1.0 / golden_ratio;
  return {on_unit_sphere({{1, 1, 1},   {1, 1, -1},  {1, -1, 1},   {1, -1, -1}, {-1, 1, 1},
                          {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}, {0, b, a},   {0, b, -a},
                          {0, -b, a},  {0, -b, -a}, {b, a, 0},    {b, -a, 0},  {-b, a, 0},
                          {-b, -a, 0}, {a, 0, b},   {-a, 0, b},   {a, 0, -b},  {-a, 0, -b}}),
          {{0, 16, 18, 1, 12},
           {2, 13, 3, 18, 16},
           {4, 14, 5, 19, 17},
           {6, 17, 19, 7, 15},
           {0, 12, 14, 4, 8},
           {1, 9, 5, 14, 12},
           {2, 10, 6, 15, 13},
           {3, 13, 15, 7, 11},
           {0, 8, 10, 2, 16},
           {4, 17, 6, 10, 8},
           {1, 18, 3, 11, 9},
           {5, 9, 11, 7, 19}}};
}

Mesh faceted(const char* name, const Polyhedron& polyhedron, float circumradius) {
  require_length(name, "circumradius", circumradius);
  SurfaceBuilder builder;
  std::vector<glm::dvec3> corners;
  for (const std::vector<std::uint32_t>& face : polyhedron.faces) {
    corners.clear();
    for (const std::uint32_t corner : face) {
      corners.push_back(polyhedron.corners[corner] * static_cast<double>(circumradius));
    }
    builder.flat_polygon(corners);
  }
  return builder.finish(name);
}

}  // namespace

/// The corners of three golden rectangles (Coxeter, "Regular Polytopes", 1948, §3.7).
Polyhedron unit_icosahedron() {
  const double a = golden_ratio;
  return {on_unit_sphere({{0, 1, a},
                          {0, -1, a},
                          {0, 1, -a},
                          {0, -1, -a},
                          {1, a, 0},
                          {-1, a, 0},
                          {1, -a, 0},
                          {-1, -a, 0},
                          {a, 0, 1},
                          {a, 0, -1},
                          {-a, 0, 1},
                          {-a, 0, -1}}),
          {{0, 8, 4},  {0, 5, 10}, {1, 6, 8},   {1, 10, 7}, {2, 4, 9},   {2, 11, 5}, {3, 9, 6},
           {3, 7, 11}, {4, 8, 9},  {5, 11, 10}, {6, 9, 8},  {7, 10, 11}, {0, 4, 5},  {1, 7, 6},
           {2, 5, 4},  {3, 6, 7},  {0, 1, 8},   {2, 9, 3},  {0, 10, 1},  {2, 3, 11}}};
}

Mesh tetrahedron(float circumradius) {
  const FloatingPointScope floating_point;
  return faceted("tetrahedron", unit_tetrahedron(), circumradius);
}
Mesh octahedron(float circumradius) {
  const FloatingPointScope floating_point;
  return faceted("octahedron", unit_octahedron(), circumradius);
}
Mesh dodecahedron(float circumradius) {
  const FloatingPointScope floating_point;
  return faceted("dodecahedron", unit_dodecahedron(), circumradius);
}
Mesh icosahedron(float circumradius) {
  const FloatingPointScope floating_point;
  return faceted("icosahedron", unit_icosahedron(), circumradius);
}

}  // namespace velum::shapes
