#pragma once

#include "outcode.hpp"

namespace velum {

/// Which planes cut a triangle. Near and far always do; the sides of the view volume need not, since what
/// lies beyond them is outside of the picture anyway.
enum class ClipPolicy {
  guard,  ///< the sides of a guard band around the picture: fewer cuts
  exact   ///< all six planes of the view volume, as in the textbook
};

/// The widest and highest that picture and guard band together are, pixels.
inline constexpr int widest_guard_band = 32768;

/// What triangles are clipped against: -x·w ≤ X ≤ x·w, -y·w ≤ Y ≤ y·w, 0 ≤ Z ≤ w. As it stands here it is the
/// canonical view volume.
struct ClipVolume {
  double x = 1.0;
  double y = 1.0;
};

/// The guard band along an axis of `pixels`: the picture blown up about its middle by the largest power of
/// two that keeps it within widest_guard_band: 16 for 1920 and for 1080 pixels, 1 for more than 16384.
///
/// Why that: snapped coordinates then lie within ±2²² of the picture's middle, no farther from each other
/// than those in the largest picture, so every sum of the rasters has room. A power of two multiplies
/// exactly, and so what clip_triangle() promises for the sides of the view volume holds for these too.
constexpr double guard_band(int pixels) {
  double factor = 1.0;
  while (2.0 * factor * pixels <= widest_guard_band) factor *= 2.0;
  return factor;
}

/// @param width, height  of the whole picture, pixels, 1 … 32768
constexpr ClipVolume clip_volume(ClipPolicy policy, int width, int height) {
  return policy == ClipPolicy::exact ? ClipVolume{} : ClipVolume{guard_band(width), guard_band(height)};
}

/// Row `plane` of clip_planes for the volume.
constexpr ClipPlaneRow plane_of(const ClipVolume& volume, ClipPlane plane) {
  ClipPlaneRow row = clip_planes[static_cast<unsigned>(plane)];
  if (row.axis == 0) row.bound *= volume.x;
  if (row.axis == 1) row.bound *= volume.y;
  return row;
}

/// The planes of the volume that a homogeneous point is outside of; NaN counts as outside.
constexpr Outcode outcode(const glm::dvec4& v, const ClipVolume& volume) {
  unsigned code = 0;
  for (int i = 0; i < clip_plane_count; ++i) {
    if (!(signed_value(plane_of(volume, static_cast<ClipPlane>(i)), v) >= 0.0)) code |= 1u << i;
  }
  return static_cast<Outcode>(code);
}

/// The rule for a vertex: one that satisfies it has a place on the picture or in the guard band around it,
/// and a finite triangle whose three vertices do is drawn without being cut.
constexpr bool needs_no_cut(const glm::dvec4& v, const ClipVolume& volume) {
  return outcode(v, volume) == 0 && v.w > 0.0;
}

}  // namespace velum
