#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "../raycast/camera_rays.hpp"
#include "../raycast/intersection/cylinder_intersection.hpp"
#include "../raycast/intersection/sphere_intersection.hpp"
#include "../scene/scene.hpp"
#include "settings.hpp"

namespace velum {

/// A body given by its equation, in the object space of an instance whose mesh has its vertices on it. A
/// model matrix makes ellipsoids of spheres.
using AnalyticBody = std::variant<Sphere, Cylinder>;

/// Where a ray meets a body first.
struct AnalyticHit {
  double t = 0.0;          ///< of the world ray
  glm::dvec3 normal{0.0};  ///< of the body there; world space, unit length, outwards
  std::uint32_t object = 0;
  bool back_facing = false;  ///< seen from inside
};

/// Bodies with their places in a scene, asked by rays.
class AnalyticView {
 public:
  /// @param bodies  of each instance. @pre as many as instances
  AnalyticView(const Scene& scene, std::span<const AnalyticBody> bodies, Cull cull = Cull::none);

  /// What a ray meets first in its range, of what is not culled; of equals the first instance.
  std::optional<AnalyticHit> first_hit(const ViewRay& view) const;

 private:
  struct Placed {
    AnalyticBody body;
    glm::dmat4 object_from_world;
  };

  bool is_wanted(const AnalyticHit& hit) const;

  std::vector<Placed> placed_;
  Cull cull_;
};

}  // namespace velum
