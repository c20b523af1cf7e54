#include "watertight.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "../../base/double_double.hpp"

namespace velum {
namespace {

/// A vertex as the ray sees it: the ray runs from (0, 0) along z, and z is its parameter t.
struct SeenVertex {
  double x, y, z;
};

inline SeenVertex seen(const PreparedRay& ray, const glm::dvec3& vertex) {
  const double x = vertex[ray.kx] - ray.ray.origin[ray.kx];
  const double y = vertex[ray.ky] - ray.ray.origin[ray.ky];
  const double z = vertex[ray.kz] - ray.ray.origin[ray.kz];
  return {x - ray.shear_x * z, y - ray.shear_y * z, ray.scale_z * z};
}

int sign(double v) {
  return v > 0.0 ? 1 : (v < 0.0 ? -1 : 0);
}

/// On which side of p → q the ray passes: 1 left, -1 right, 0 exactly through it.
/// @param value  p.x·q.y - p.y·q.x, rounded: it is never on the wrong side, but may be 0
int side(double value, const SeenVertex& p, const SeenVertex& q) {
  if (value != 0.0) return sign(value);
  const elementary::DoubleDouble one = elementary::two_product(p.x, q.y);
  const elementary::DoubleDouble other = elementary::two_product(p.y, q.x);
  return sign((one.high - other.high) + (one.low - other.low));
}

/// The top-left rule: of the two directions in which an edge can run, one owns its points.
bool owns_its_points(const SeenVertex& p, const SeenVertex& q) {
  return q.y < p.y || (q.y == p.y && q.x < p.x);
}

/// Whether the three edges, exactly, have the ray on one side.
bool is_inside(const std::array<double, 3>& value, const std::array<SeenVertex, 3>& v) {
  const std::array<int, 3> sides{side(value[0], v[1], v[2]), side(value[1], v[2], v[0]),
                                 side(value[2], v[0], v[1])};
  const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
  if (*least < 0 && *most > 0) return false;
  const int orientation = *least + *most;  // one of them may be 0
  if (orientation == 0) return false;      // seen edge-on
  for (std::size_t i = 0; i < 3; ++i) {
    if (sides[i] != 0) continue;
    const SeenVertex& p = v[(i + 1) % 3];
    const SeenVertex& q = v[(i + 2) % 3];
    if (!(orientation > 0 ? owns_its_points(p, q) : owns_its_points(q, p))) return false;
  }
  return true;
}

}  // namespace

std::optional<TriangleHit> intersect_watertight(const PreparedRay& ray, const Triangle& triangle) {
  if (!ray.usable) return {};
  const std::array<SeenVertex, 3> v{seen(ray, triangle.a), seen(ray, triangle.b), seen(ray, triangle.c)};
  const std::array<double, 3> value{v[1].x * v[2].y - v[1].y * v[2].x, v[2].x * v[0].y - v[2].y * v[0].x,
                                    v[0].x * v[1].y - v[0].y * v[1].x};
  const bool some_left = value[0] > 0.0 || value[1] > 0.0 || value[2] > 0.0;
  const bool some_right = value[0] < 0.0 || value[1] < 0.0 || value[2] < 0.0;
  if (some_left && some_right) return {};
  const bool on_an_edge = value[0] == 0.0 || value[1] == 0.0 || value[2] == 0.0;
  if (on_an_edge && !is_inside(value, v)) return {};
  const double determinant = value[0] + value[1] + value[2];
  const glm::dvec3 barycentric = determinant == 0.0 ? glm::dvec3(1.0 / 3.0)  // an area that rounded to 0
                                                    : glm::dvec3(value[0], value[1], value[2]) / determinant;
  const double t = barycentric.x * v[0].z + barycentric.y * v[1].z + barycentric.z * v[2].z;
  const Interval box = ray.through(glm::min(glm::min(triangle.a, triangle.b), triangle.c),
                                   glm::max(glm::max(triangle.a, triangle.b), triangle.c));
  if (box.is_empty() || !(t == t)) return {};
  return TriangleHit{std::clamp(t, box.lower, box.upper), barycentric};
}

}  // namespace velum
