#include "outside_view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace velum {
namespace {

glm::dvec3 unit(const glm::dvec3& v) {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0.0 ? v / length : v;
}

bool is_finite(const glm::dvec3& v) {
  return v - v == glm::dvec3(0.0);
}

/// How far the scene reaches behind the near plane, as a share of the way to the far plane.
double share_to_scene_end(const std::array<glm::dvec3, 8>& volume, const Aabb& scene) {
  const glm::dvec3 across = glm::cross(volume[1] - volume[0], volume[2] - volume[0]);
  const double to_far = glm::dot(volume[4] - volume[0], across);
  double farthest = 0.0;
  for (const glm::dvec3& corner : scene.corners()) {
    farthest = std::max(farthest, glm::dot(corner - volume[0], across) / to_far);
  }
  return farthest;
}

/// The axes of a camera, and how far points reach along them.
struct Extent {
  glm::dvec3 right, up, back;
  glm::dvec3 lower{1e300}, upper{-1e300};

  void include(const glm::dvec3& p) {
    const glm::dvec3 along(glm::dot(p, right), glm::dot(p, up), glm::dot(p, back));
    lower = glm::min(lower, along);
    upper = glm::max(upper, along);
  }
  glm::dvec3 middle() const {
    const glm::dvec3 m = (lower + upper) * 0.5;
    return right * m.x + up * m.y + back * m.z;
  }
};

/// From where the second camera looks: a unit vector.
glm::dvec3 outside_direction(const std::optional<ShownVolume>& volume, const glm::dvec3& up) {
  if (!volume) return unit({1.0, 1.0, 1.0});
  const auto& v = volume->corners;
  const glm::dvec3 aside = unit(v[1] - v[0]);
  const glm::dvec3 behind = unit((v[0] + v[3]) - (v[4] + v[7]));
  return unit(aside * 0.8 + up * 0.55 + behind * 0.2);
}

}  // namespace

std::optional<ShownVolume> shown_volume(const ViewingTransform& viewing, const Aabb& scene) {
  const glm::dmat4 world_from_clip = viewing.world_from_clip();
  ShownVolume volume;
  const std::array<glm::dvec3, 8> canonical = Aabb{{-1.0, -1.0, 0.0}, {1.0, 1.0, 1.0}}.corners();
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::dvec4 corner = world_from_clip * glm::dvec4(canonical[i], 1.0);
    volume.corners[i] = glm::dvec3(corner) / corner.w;
    if (!is_finite(volume.corners[i])) return {};
  }
  const double end = 1.05 * share_to_scene_end(volume.corners, scene);
  volume.is_cut = end > 0.0 && end < 0.8;
  for (std::size_t i = 0; volume.is_cut && i < 4; ++i) {
    volume.corners[i + 4] = volume.corners[i] + (volume.corners[i + 4] - volume.corners[i]) * end;
  }
  const glm::dvec4 eye = eye_of(viewing.clip_from_world());
  if (std::abs(eye.w) > 0.0) volume.eye = glm::dvec3(eye) / eye.w;
  return volume;
}

Camera outside_camera(const Aabb& scene, const std::optional<ShownVolume>& volume, const glm::dvec3& up,
                      double aspect, double margin) {
  Extent extent;
  extent.back = outside_direction(volume, up);
  const bool is_along_up = std::abs(glm::dot(extent.back, up)) > 0.99;
  const glm::dvec3 upright = is_along_up ? glm::dvec3(up.z, up.x, up.y) : up;
  extent.right = unit(glm::cross(upright, extent.back));
  extent.up = glm::cross(extent.back, extent.right);
  for (const glm::dvec3& corner : scene.corners()) extent.include(corner);
  if (volume) {
    for (const glm::dvec3& corner : volume->corners) extent.include(corner);
    for (std::size_t i = 0; volume->is_cut && i < 4; ++i) extent.include(volume->beyond(i));
    if (volume->eye) extent.include(*volume->eye);
  }
  const glm::dvec3 size = extent.upper - extent.lower;
  const double height = std::max({size.y, size.x / aspect, 1e-12}) / (1.0 - 2.0 * margin);
  const double reach = 0.5 * size.z + height;
  return Camera::parallel({extent.middle(), -extent.back, extent.up}, {height}, -reach, reach);
}

}  // namespace velum
