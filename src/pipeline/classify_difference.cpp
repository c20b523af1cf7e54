#include "classify_difference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "../image/visibility_buffer.hpp"
#include "../projection/facing.hpp"
#include "../visibility/depth_plane.hpp"
#include "stages.hpp"

namespace velum {
namespace {

constexpr double far_away = std::numeric_limits<double>::infinity();

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 ab = b - a;
  const double length2 = glm::dot(ab, ab);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + ab * t));
}

/// The signed homogeneous distance inside the near plane (z ≥ 0) or the far plane (z ≤ w).
double inside(const glm::dvec4& v, bool at_near) {
  return at_near ? v.z : v.w - v.z;
}

glm::dvec4 crossing(const glm::dvec4& a, const glm::dvec4& b, bool at_near) {
  const double da = inside(a, at_near);
  return a + (b - a) * (da / (da - inside(b, at_near)));
}

/// How wrong w - z of a vertex can be in double. Where far is many times near, w and z are nearly equal, and
/// what they differ by is near / distance: with far/near above 10^9 this counts beside float32. Each of the
/// terms of the two sums is rounded at most eight times: at most five products of stages, one product, two
/// sums; the difference itself once more.
double clip_rounding_of(const glm::dmat4& clip_from_object, const glm::vec3& position) {
  const glm::dvec4 p(position, 1.0);
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    sum += (std::fabs(clip_from_object[i].z) + std::fabs(clip_from_object[i].w)) * std::fabs(p[i]);
  }
  return 9.0 * 0x1.0p-53 * sum;
}

}  // namespace

/// A triangle of the scene in clip space.
struct DifferenceClassifier::SeenTriangle {
  std::array<glm::dvec4, 3> v;
  const Viewport& viewport;
  double clip_rounding = 0.0;  ///< the largest error of any vertex's w - z, see clip_rounding_of()

  glm::dvec2 pixel_of(const glm::dvec4& p) const { return viewport.pixel_from_ndc(p.x / p.w, p.y / p.w); }

  /// From a place on the picture to an edge as far as it is between the near and the far plane, pixels.
  double distance_to_edge(const glm::dvec2& p, glm::dvec4 a, glm::dvec4 b) const {
    for (const bool at_near : {true, false}) {
      const bool a_out = inside(a, at_near) < 0.0, b_out = inside(b, at_near) < 0.0;
      if (a_out && b_out) return far_away;
      if (a_out) a = crossing(a, b, at_near);
      if (b_out) b = crossing(a, b, at_near);
    }
    if (!(a.w > 0.0 && b.w > 0.0)) return far_away;
    return distance_to_segment(p, pixel_of(a), pixel_of(b));
  }

  bool is_near_edge(const glm::dvec2& p) const {
    return distance_to_edge(p, v[0], v[1]) <= snapping_reach ||
           distance_to_edge(p, v[1], v[2]) <= snapping_reach ||
           distance_to_edge(p, v[2], v[0]) <= snapping_reach;
  }

  /// The line where the near or the far plane cuts the triangle.
  bool is_near_cut(const glm::dvec2& p, bool at_near) const {
    std::array<glm::dvec2, 3> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec4& a = v[i];
      const glm::dvec4& b = v[(i + 1) % 3];
      if ((inside(a, at_near) < 0.0) == (inside(b, at_near) < 0.0)) continue;
      const glm::dvec4 c = crossing(a, b, at_near);
      if (!(c.w > 0.0)) return false;
      ends[count++] = pixel_of(c);
    }
    return count == 2 && distance_to_segment(p, ends[0], ends[1]) <= snapping_reach;
  }

  /// Whether the triangle is seen at a place where double cannot tell on which side of the near or far plane
  /// it lies. Where far is many times near, a surface is so close to the far plane as soon as it is close for
  /// the eye.
  bool is_in_cut(const glm::dvec2& p) const {
    const glm::dvec3 weights = weights_at(p);
    const bool covers = (weights.x >= 0.0 && weights.y >= 0.0 && weights.z >= 0.0) ||
                        (weights.x <= 0.0 && weights.y <= 0.0 && weights.z <= 0.0);
    const double r = reversed_depth(p);
    return covers && std::min(std::fabs(r), std::fabs(1.0 - r)) <= clip_rounding * inverse_w(p);
  }

  /// The reversed depth r = 1 - z of the triangle's plane at a place on the picture, in double: of the point
  /// with that image on the plane through the three homogeneous vertices.
  double reversed_depth(const glm::dvec2& p) const {
    const glm::dvec3 weights = weights_at(p);
    const glm::dvec3 r(v[0].w - v[0].z, v[1].w - v[1].z, v[2].w - v[2].z);
    return glm::dot(weights, r) / glm::dot(weights, glm::dvec3(v[0].w, v[1].w, v[2].w));
  }

  /// The largest error of the float32 expression r = (r_ref + dx·Δx) + dy·Δy: each of its terms is rounded at
  /// most four times (coefficient, product, two sums), each time by at most 2^-24 of the terms' absolute sum.
  double depth_error(int x, int y) const {
    const DepthPlane plane = depth_plane(v, homogeneous_determinant(v[0], v[1], v[2]), viewport);
    const double across = std::fabs(static_cast<double>(plane.dx)) * (std::abs(x - plane.x_ref) + 1);
    const double down = std::fabs(static_cast<double>(plane.dy)) * (std::abs(y - plane.y_ref) + 1);
    const double r = std::fabs(reversed_depth({x + 0.5, y + 0.5}));
    return 4.0 * 0x1.0p-24 * (r + 2.0 * across + 2.0 * down) + clip_rounding * inverse_w({x + 0.5, y + 0.5});
  }

  /// 1 / w of the triangle's plane at a place on the picture: how far an error of w - z moves r there.
  double inverse_w(const glm::dvec2& p) const {
    const glm::dvec3 weights = weights_at(p);
    const double w = glm::dot(weights, glm::dvec3(v[0].w, v[1].w, v[2].w));
    return (std::fabs(weights.x) + std::fabs(weights.y) + std::fabs(weights.z)) / std::fabs(w);
  }

  /// The shares, up to one factor, with which the homogeneous vertices add up to the point of the triangle's
  /// plane that has its image at a place on the picture. Of one sign: it lies in the triangle.
  glm::dvec3 weights_at(const glm::dvec2& p) const {
    const glm::dvec2 ndc = viewport.ndc_from_pixel(p.x, p.y);
    const auto xyw = [](const glm::dvec4& q) { return glm::dvec3(q.x, q.y, q.w); };
    const glm::dvec3 at(ndc.x, ndc.y, 1.0);
    return {glm::dot(at, glm::cross(xyw(v[1]), xyw(v[2]))), glm::dot(at, glm::cross(xyw(v[2]), xyw(v[0]))),
            glm::dot(at, glm::cross(xyw(v[0]), xyw(v[1])))};
  }
};

DifferenceClassifier::DifferenceClassifier(const Scene& scene, const ViewingTransform& viewing,
                                           const RenderSettings& settings)
    : scene_(scene), viewing_(viewing), viewport_{settings.width, settings.height} {}

bool DifferenceClassifier::is_triangle(std::uint32_t primitive) const {
  return primitive != no_primitive && scene_.place(primitive).kind == PrimitiveKind::triangle;
}

DifferenceClassifier::SeenTriangle DifferenceClassifier::seen(std::uint32_t primitive) const {
  const PrimitivePlace place = scene_.place(primitive);
  const Instance& instance = scene_.instances()[place.instance];
  const Mesh& mesh = scene_.meshes()[instance.mesh];
  const glm::dmat4 clip_from_object = viewing_.clip_from_object(instance.world_from_object);
  const glm::uvec3& t = mesh.triangles[place.index];
  SeenTriangle result{{}, viewport_};
  for (int i = 0; i < 3; ++i) {
    const glm::vec3& position = mesh.positions[t[i]];
    result.v[static_cast<std::size_t>(i)] = clip_position(clip_from_object, position);
    result.clip_rounding = std::max(result.clip_rounding, clip_rounding_of(clip_from_object, position));
  }
  return result;
}

Agreement DifferenceClassifier::classify(int x, int y, std::uint32_t raster, std::uint32_t ray) const {
  if (raster == ray) return Agreement::same;
  const glm::dvec2 centre(x + 0.5, y + 0.5);
  for (const std::uint32_t id : {raster, ray}) {
    if (is_triangle(id) && seen(id).is_near_edge(centre)) return Agreement::edge;
  }
  for (const std::uint32_t id : {raster, ray}) {
    if (!is_triangle(id)) continue;
    const SeenTriangle triangle = seen(id);
    if (triangle.is_near_cut(centre, true) || triangle.is_near_cut(centre, false) ||
        triangle.is_in_cut(centre)) {
      return Agreement::cut;
    }
  }
  if (!is_triangle(raster) || !is_triangle(ray)) return Agreement::unexplained;
  const SeenTriangle one = seen(raster), other = seen(ray);
  const double apart = std::fabs(one.reversed_depth(centre) - other.reversed_depth(centre));
  return apart <= one.depth_error(x, y) + other.depth_error(x, y) ? Agreement::tie : Agreement::unexplained;
}

}  // namespace velum
