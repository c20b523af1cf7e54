#pragma once

#include <glm/vec4.hpp>

#include "../spatial/normal_cone.hpp"
#include "box_projection.hpp"

namespace velum {

/// Which way all triangles of a cluster face, by their normal cone.
class ConeCulling {
 public:
  /// @param projection  of the mesh; must live as long as this
  explicit ConeCulling(const BoxProjection& projection);

  /// Whether the homogeneous determinants of all the triangles are certain to have the sign (1 or -1), as
  /// they are computed, not only in exact arithmetic.
  /// @param box  around the cluster
  bool all_have_sign(const NormalCone& cone, const Aabb& box, double sign) const;

  /// The same in general: whether the middle of the cluster has it. A guess that may be wrong.
  bool has_sign(const NormalCone& cone, const Aabb& box, double sign) const;

 private:
  const BoxProjection& projection_;
  /// Of a triangle through p with normal n, twice its area long: determinant = n·(eye.xyz - p·eye.w).
  glm::dvec4 eye_;
  double stretch_ = 0.0;  ///< a bound on how much longer (x, y, w) may be than an edge in object space
};

}  // namespace velum
