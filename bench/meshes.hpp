#pragma once

#include <velum/velum.hpp>

namespace velum_bench {

/// Positions and triangles only: what both contenders draw from.
velum::Mesh without_attributes(velum::Mesh mesh);

/// Every triangle in four at the middles of its edges; vertices on shared edges are shared.
velum::Mesh subdivided(const velum::Mesh& mesh);

/// A sphere of about so many triangles, radius 1.
velum::Mesh sphere_of(double triangles);

/// Hills over a square of side 2 around the origin, y up, of about so many triangles.
velum::Mesh terrain_of(double triangles);

/// 32 quads, each 1.01 × the view volume's section at distances 1.5, 2.0, … 17.0 in front of a camera at the
/// origin that looks along -z. @param vertical_angle radians
velum::Mesh filling_quads(bool back_to_front, double vertical_angle, double aspect);

/// 10 × 10 × 10 instances of the mesh, 1.2 × its box apart in each axis, around where it stands.
velum::Scene thousand_times(velum::Mesh mesh);

}  // namespace velum_bench
