#pragma once

#include <algorithm>
#include <array>

#include "ray_oracle.hpp"

/// Why raster and oracle may differ at a pixel (DESIGN, the definition): the centre lies within √2/512 pixel
/// of a true edge (snapping moves a vertex by at most half of 1/256 pixel in x and in y), or of the cut with
/// the near or far plane, or the two depths are equal within the rounding of float32.
namespace oracle {

enum class Reason { same, edge, cut, tie, unexplained };

/// √2/512 and what double precision may lose on the way.
inline constexpr double snapping_reach = 1.4142135623730951 / 512.0 + 1e-6;

inline double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 ab = b - a;
  const double length2 = glm::dot(ab, ab);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + ab * t));
}

/// The distance in pixels from p to the projected segment between two camera-space points, cut to near ≤
/// depth ≤ far.
inline double distance_to_edge(const Eye& eye, const glm::dvec2& p, glm::dvec3 a, glm::dvec3 b) {
  for (const bool at_near : {true, false}) {
    const double sign = at_near ? 1.0 : -1.0;
    const double bound = at_near ? eye.near : eye.far;
    const double da = sign * (a.z - bound);
    const double db = sign * (b.z - bound);
    if (da < 0.0 && db < 0.0) return 1e300;
    if (da < 0.0) a = b + (a - b) * (db / (db - da));
    if (db < 0.0) b = a + (b - a) * (da / (da - db));
  }
  return distance_to_segment(p, eye.pixel_of(a), eye.pixel_of(b));
}

/// The distance in pixels to the cut of the triangle with the plane depth = bound; 1e300 if there is none.
inline double distance_to_cut(const Eye& eye, const glm::dvec2& p, const std::array<glm::dvec3, 3>& v,
                              double bound) {
  std::array<glm::dvec2, 3> ends;
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& a = v[static_cast<std::size_t>(i)];
    const glm::dvec3& b = v[static_cast<std::size_t>((i + 1) % 3)];
    if ((a.z < bound) == (b.z < bound)) continue;
    const glm::dvec3 c = a + (b - a) * ((bound - a.z) / (b.z - a.z));
    ends[static_cast<std::size_t>(count++)] = eye.pixel_of({c.x, c.y, bound});
  }
  return count == 2 ? distance_to_segment(p, ends[0], ends[1]) : 1e300;
}

/// The reversed depth of a triangle's plane at a pixel position, wherever the triangle ends.
inline double plane_reversed_depth(const Eye& eye, const WorldTriangle& t, double px, double py) {
  const glm::dvec3 origin = eye.at(px, py, 0.0);
  const glm::dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
  return eye.reversed_depth(glm::dot(normal, t.a - origin) / glm::dot(normal, eye.at(px, py, 1.0) - origin));
}

/// The largest error of the float32 evaluation r = (r_ref + dx·Δx) + dy·Δy: each of the three terms is
/// rounded at most four times on the way (coefficient, product, two sums), each time by at most 2^-24 of the
/// terms' absolute sum.
inline double depth_error(const Eye& eye, const WorldTriangle& t, const glm::dvec2& p) {
  const double r = plane_reversed_depth(eye, t, p.x, p.y);
  const double dx = plane_reversed_depth(eye, t, p.x + 1.0, p.y) - r;
  const double dy = plane_reversed_depth(eye, t, p.x, p.y + 1.0) - r;
  glm::dvec3 farthest = eye.camera_from(t.a);
  for (const glm::dvec3& vertex : {t.b, t.c}) {
    if (eye.camera_from(vertex).z > farthest.z) farthest = eye.camera_from(vertex);
  }
  const glm::dvec2 reference =
      glm::clamp(eye.pixel_of(farthest), glm::dvec2(0.0), glm::dvec2(eye.width, eye.height)) - p;
  const double x_term = std::fabs(dx) * (std::fabs(reference.x) + 1.0);
  const double y_term = std::fabs(dy) * (std::fabs(reference.y) + 1.0);
  return 4.0 * 0x1.0p-24 * (std::fabs(r) + 2.0 * x_term + 2.0 * y_term);
}

struct Comparison {
  std::uint64_t counts[5] = {};
  std::uint64_t pixels = 0;
  std::uint64_t of(Reason reason) const { return counts[static_cast<int>(reason)]; }
};

class Classifier {
 public:
  Classifier(const Eye& eye, const std::vector<WorldTriangle>& triangles)
      : eye_(eye), triangles_(triangles) {}

  Reason reason(int x, int y, std::uint32_t raster, const Hit& hit) const {
    if (raster == hit.primitive) return Reason::same;
    const glm::dvec2 centre(x + 0.5, y + 0.5);
    for (const std::uint32_t id : {raster, hit.primitive}) {
      if (id != velum::no_primitive && is_near_edge(centre, id)) return Reason::edge;
    }
    for (const std::uint32_t id : {raster, hit.primitive}) {
      if (id != velum::no_primitive && is_near_cut(centre, id)) return Reason::cut;
    }
    return is_tie(centre, raster, hit) ? Reason::tie : Reason::unexplained;
  }

 private:
  std::array<glm::dvec3, 3> in_camera(std::uint32_t id) const {
    const WorldTriangle& t = triangles_[id];
    return {eye_.camera_from(t.a), eye_.camera_from(t.b), eye_.camera_from(t.c)};
  }
  bool is_near_edge(const glm::dvec2& centre, std::uint32_t id) const {
    const auto v = in_camera(id);
    return distance_to_edge(eye_, centre, v[0], v[1]) <= snapping_reach ||
           distance_to_edge(eye_, centre, v[1], v[2]) <= snapping_reach ||
           distance_to_edge(eye_, centre, v[2], v[0]) <= snapping_reach;
  }
  bool is_near_cut(const glm::dvec2& centre, std::uint32_t id) const {
    const auto v = in_camera(id);
    return distance_to_cut(eye_, centre, v, eye_.near) <= snapping_reach ||
           distance_to_cut(eye_, centre, v, eye_.far) <= snapping_reach;
  }
  bool is_tie(const glm::dvec2& centre, std::uint32_t raster, const Hit& hit) const {
    if (raster == velum::no_primitive || hit.primitive == velum::no_primitive) return false;
    const auto depth = depth_of_hit(eye_, triangles_[raster], centre.x, centre.y);
    if (!depth) return false;
    const double bound =
        depth_error(eye_, triangles_[raster], centre) + depth_error(eye_, triangles_[hit.primitive], centre);
    return std::fabs(eye_.reversed_depth(*depth) - hit.reversed_depth) <= bound;
  }

  const Eye& eye_;
  const std::vector<WorldTriangle>& triangles_;
};

/// Compares a picture of ids with the oracle, pixel by pixel.
inline Comparison compare(const velum::Scene& scene, const velum::Camera& camera,
                          const velum::Image<std::uint32_t>& ids) {
  const Eye eye(camera, ids.width(), ids.height());
  const std::vector<WorldTriangle> triangles = world_triangles(scene);
  const Classifier classifier(eye, triangles);
  Comparison result;
  for (int y = 0; y < ids.height(); ++y) {
    for (int x = 0; x < ids.width(); ++x) {
      const Hit hit = cast(eye, triangles, x, y);
      ++result.counts[static_cast<int>(classifier.reason(x, y, ids.at(x, y), hit))];
      ++result.pixels;
    }
  }
  return result;
}

}  // namespace oracle
