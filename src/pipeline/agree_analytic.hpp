#pragma once

#include <span>

#include "../projection/camera.hpp"
#include "analytic_view.hpp"
#include "settings.hpp"

namespace velum {

/// The largest share of a body (shrunk about its centre; a cylinder about its axis) that the triangles of a
/// mesh enclose: the mesh lies between that and the body. 1 - cos(π/n) below 1 for a cylinder of n sides, so
/// that it comes four times as near to 1 when the tessellation doubles.
/// @pre the mesh is closed around the centre; no vertex lies outside the body, and some on it
double inner_share(const AnalyticBody& body, const Mesh& mesh);

/// Which object is seen where: triangles by the raster against equations by rays, see render_analytic().
struct AnalyticAgreement {
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0;      ///< pixels where at least one of them sees something
  std::uint64_t silhouette = 0;   ///< differ, and the ray runs between a body and what its mesh encloses
  std::uint64_t unexplained = 0;  ///< differ otherwise: a fault
  /// The least inner_share() of all bodies: a ray at a silhouette passes the centre (axis) at a distance
  /// between this share of the radius and the radius, so no farther from the outline than
  /// (1 - share) · radius.
  double inner_share = 1.0;
};

/// Compares the ids of objects. A pixel that differs is explained by the tessellation if its ray, moved by no
/// more than snapping moves vertices (half a step of the grid, 1/512 pixel, in x and in y), meets a body but
/// not the part that the mesh encloses.
/// @param bodies  of each instance. @pre as many as instances; each mesh is one closed body
/// @param settings  size and culling; visibility and shading are not looked at
/// @throws Error as render()
AnalyticAgreement agree_analytic(const Scene& scene, std::span<const AnalyticBody> bodies,
                                 const Camera& camera, const RenderSettings& settings);

}  // namespace velum
