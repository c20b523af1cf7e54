#pragma once

#include <string>
#include <vector>

#include "../projection/camera.hpp"
#include "../raycast/camera_rays.hpp"
#include "../raycast/scene_caster.hpp"
#include "../scene/scene.hpp"
#include "settings.hpp"

namespace velum {

/// Why a ray misses a box: it is out of one pair of sides before it is between another pair.
struct SlabGap {
  int left_axis = 0;  ///< 0, 1, 2: the ray leaves the slab across this axis first, at t = left …
  double left = 0.0;
  int entered_axis = 0;  ///< … and enters this one last, at t = entered > left
  double entered = 0.0;
};

/// One step of a ray through the bounding volume hierarchies, in the order in which they are taken.
struct RayStep {
  enum class Kind { box, instance, triangle };
  enum class Outcome {
    entered,     ///< box, instance: what is inside is looked at
    missed,      ///< the ray passes by
    not_wanted,  ///< met only before the near or behind the far plane
    beyond_hit,  ///< entered later than the nearest hit so far
    nearest,     ///< triangle: hit, the nearest so far
    farther,     ///< triangle: hit, behind another hit
    culled,      ///< triangle: hit, left out by the way it faces
  };
  Kind kind = Kind::box;
  Outcome outcome = Outcome::missed;
  int level = 0;            ///< how deep, for indenting
  bool is_leaf = false;     ///< box: holds instances or triangles
  std::uint32_t index = 0;  ///< box: node; instance; triangle: primitive id in the scene
  Box box;                  ///< box: world space above the instances, else object space
  Interval inside;          ///< box: where the ray is in it; triangle: its t, twice
  SlabGap gap;              ///< of a box that is missed
};

/// Why a step ended as it did, in a few words: "missed: leaves x before it enters y".
std::string reason_of(const RayStep& step);

/// What the ray through a pixel's centre meets, and how it was found.
struct RayExplanation {
  int x = 0;
  int y = 0;
  ViewRay ray;                     ///< world space; t from 0 (near plane) to 1 (far plane), see CameraRays
  SceneHit hit;                    ///< what is seen
  std::vector<SceneHit> hits;      ///< everything on the way, nearest first; culled triangles left out
  std::vector<RayStep> traversal;  ///< to the first hit, with AcceleratorKind::binary_bvh
  CastCounters counters;           ///< of the first hit, with the settings' accelerator
};

/// @param settings  size, culling, accelerator
/// @throws Error (usage) for a pixel outside the picture, and as render()
RayExplanation explain_ray(const Scene& scene, const Camera& camera, const RenderSettings& settings, int x,
                           int y);

}  // namespace velum
