#include "bounding_volume.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "../base/aabb.hpp"
#include "convex_hull.hpp"
#include "enclosing_ellipsoid.hpp"

namespace velum {
namespace {

Aabb box_of(std::span<const glm::vec3> points) {
  Aabb box;
  for (const glm::vec3& p : points) box.include(glm::dvec3(p));
  return box;
}

/// Both normals of a slab across (x, y, z).
void add_slab(std::vector<glm::dvec3>& normals, double x, double y, double z) {
  const glm::dvec3 n = glm::normalize(glm::dvec3(x, y, z));
  normals.push_back(n);
  normals.push_back(-n);
}

std::vector<glm::dvec3> dop_normals(VolumeKind kind) {
  std::vector<glm::dvec3> normals;
  add_slab(normals, 1, 0, 0);
  add_slab(normals, 0, 1, 0);
  add_slab(normals, 0, 0, 1);
  if (kind == VolumeKind::dop14 || kind == VolumeKind::dop26) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) add_slab(normals, 1, y, z);
    }
  }
  if (kind == VolumeKind::dop18 || kind == VolumeKind::dop26) {
    for (const double s : {-1.0, 1.0}) {
      add_slab(normals, 1, s, 0);
      add_slab(normals, 0, 1, s);
      add_slab(normals, s, 0, 1);
    }
  }
  return normals;
}

/// The planes with these normals that touch the points from outside.
std::vector<Plane> touching_planes(std::span<const glm::dvec3> normals, std::span<const glm::vec3> points) {
  std::vector<Plane> planes;
  for (const glm::dvec3& normal : normals) {
    double farthest = glm::dot(normal, glm::dvec3(points[0]));
    for (const glm::vec3& p : points) farthest = std::max(farthest, glm::dot(normal, glm::dvec3(p)));
    planes.push_back({normal, -farthest});
  }
  return planes;
}

BoundingVolume round_volume(VolumeKind kind, std::span<const glm::vec3> points, double size) {
  BoundingVolume volume;
  volume.kind = kind;
  if (kind == VolumeKind::ellipsoid) {
    const EnclosingEllipsoid ellipsoid = enclosing_ellipsoid(points);
    volume.centre = ellipsoid.centre;
    volume.ball_from_space = ellipsoid.ball_from_space;
  } else {
    const EnclosingBall ball = enclosing_ball(points);
    volume.centre = ball.centre;
    const double radius = std::max(ball.radius, 0x1.0p-60 * size);
    volume.ball_from_space = glm::dmat3(radius > 0.0 ? 1.0 / radius : 0x1.0p500);
  }
  volume.area = ellipsoid_area(volume.ball_from_space);
  return volume;
}

}  // namespace

std::span<const VolumeName> volume_names() {
  static constexpr std::array names{
      VolumeName{"sphere", VolumeKind::sphere},    VolumeName{"ellipsoid", VolumeKind::ellipsoid},
      VolumeName{"aabb", VolumeKind::aabb},        VolumeName{"14-dop", VolumeKind::dop14},
      VolumeName{"18-dop", VolumeKind::dop18},     VolumeName{"26-dop", VolumeKind::dop26},
      VolumeName{"hull", VolumeKind::convex_hull},
  };
  return names;
}

EnclosingBall enclosing_ball(std::span<const glm::vec3> points) {
  const auto farthest = [points](const glm::dvec3& from) {
    glm::dvec3 result = from;
    double most = -1.0;
    for (const glm::vec3& p : points) {
      const glm::dvec3 v = glm::dvec3(p) - from;
      const double square = glm::dot(v, v);
      if (!(square > most)) continue;
      most = square;
      result = glm::dvec3(p);
    }
    return result;
  };
  constexpr int steps = 100;  // the distance to the best centre is at most radius / √steps; in practice less
  glm::dvec3 centre = box_of(points).centre();
  for (int i = 1; i <= steps; ++i) centre += (farthest(centre) - centre) / static_cast<double>(i + 1);
  return {centre, glm::length(farthest(centre) - centre) * (1.0 + 0x1.0p-45)};
}

double polytope_area(std::span<const Plane> planes, const glm::dvec3& inside, double size) {
  double area = 0.0;
  std::vector<glm::dvec3> face, cut;
  for (const Plane& plane : planes) {
    // A large square in the plane, cut by all the others.
    const glm::dvec3 n = plane.normal;
    const glm::dvec3 other = std::fabs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(n, other)) * size, v = glm::cross(n, u);
    const glm::dvec3 foot = inside - n * plane.signed_value(inside);
    face.assign({foot - u - v, foot + u - v, foot + u + v, foot - u + v});
    for (const Plane& by : planes) {
      if (&by == &plane) continue;
      cut.clear();
      for (std::size_t i = 0; i < face.size(); ++i) {
        const glm::dvec3 &p = face[i], &q = face[(i + 1) % face.size()];
        const double from = by.signed_value(p), to = by.signed_value(q);
        if (from <= 0.0) cut.push_back(p);
        if ((from <= 0.0) != (to <= 0.0)) cut.push_back(p + (q - p) * (from / (from - to)));
      }
      face.swap(cut);
      if (face.empty()) break;
    }
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < face.size(); ++i) sum += glm::cross(face[i - 1] - face[0], face[i] - face[0]);
    area += 0.5 * std::fabs(glm::dot(sum, n));
  }
  return area;
}

BoundingVolume bounding_volume(VolumeKind kind, std::span<const glm::vec3> points) {
  const Aabb box = box_of(points);
  const double size = glm::length(box.size());
  if (kind == VolumeKind::sphere || kind == VolumeKind::ellipsoid) return round_volume(kind, points, size);
  BoundingVolume volume;
  volume.kind = kind;
  std::vector<glm::dvec3> normals;
  if (kind == VolumeKind::convex_hull) normals = convex_hull_normals(points);
  if (normals.empty()) normals = dop_normals(kind == VolumeKind::convex_hull ? VolumeKind::dop26 : kind);
  volume.planes = touching_planes(normals, points);
  volume.centre = box.centre();
  volume.area = polytope_area(volume.planes, volume.centre, 2.0 * size);
  return volume;
}

}  // namespace velum
