#pragma once

#include <string_view>
#include <vector>

#include "mesh.hpp"

namespace velum {

/// Built-in shapes: parametric, with normals, outward and counter-clockwise. y is up; centred at the origin
/// unless said otherwise. Those that are closed have every edge twice, in opposite directions, after welding
/// equal positions.
/// @throws Error (usage) for parameters out of range, naming the parameter and its range
namespace shapes {

Mesh tetrahedron(float circumradius = 1.0f);
Mesh cube(float edge = 1.0f);
Mesh octahedron(float circumradius = 1.0f);
Mesh dodecahedron(float circumradius = 1.0f);
Mesh icosahedron(float circumradius = 1.0f);
Mesh box(float width = 1.0f, float height = 0.5f, float depth = 0.75f);
Mesh sphere(float radius = 1.0f, int segments = 48, int rings = 24);
Mesh icosphere(float radius = 1.0f, int subdivisions = 3);
Mesh cylinder(float radius = 0.5f, float height = 1.0f, int segments = 48);
Mesh cone(float radius = 0.5f, float height = 1.0f, int segments = 48);
Mesh torus(float major_radius = 0.75f, float minor_radius = 0.25f, int major_segments = 64,
           int minor_segments = 32);
/// A flat grid in the xz plane, facing +y; open.
Mesh grid(float size = 2.0f, int cells = 10);
Mesh stairs(int steps = 5, float width = 1.0f, float rise = 0.2f, float tread = 0.3f);
/// A small house with a gable roof and a chimney, standing on y = 0.
Mesh house();
/// A solid letter F, 0.25 thick, front towards +z: it has no symmetry, so a mirrored picture shows at once.
Mesh letter_f();

}  // namespace shapes

/// The names of the built-in shapes, as they stand behind "builtin:".
std::vector<std::string_view> builtin_names();
/// The shape with default parameters. @throws Error (usage) for an unknown name, with the known ones
Mesh builtin_shape(std::string_view name);

}  // namespace velum
