#include "camera_rays.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <initializer_list>
#include <limits>

#include "../base/floating_point.hpp"
#include "../projection/kernel.hpp"

namespace velum {
namespace {

glm::dvec3 divided(const glm::dvec4& p) {
  return glm::dvec3(p) / p.w;
}

/// From `start`, which is finite, towards `end`, which may lie at infinity or beyond; t from 0 to what is
/// returned.
ViewRay from_to(const glm::dvec4& start, const glm::dvec4& end) {
  constexpr double as_good_as_infinite = 0x1.0p-40;
  const glm::dvec3 origin = divided(start);
  if (end.w / start.w > as_good_as_infinite) return {{origin, divided(end) - origin}, {0.0, 1.0}};
  // A finite point between them instead: the share s of the way, where w is smaller by 2^20. There t = 1, and
  // t is proportional to s / w.
  const double s = (1.0 - 0x1.0p-20) * start.w / (start.w - end.w);
  const glm::dvec4 between = start + (end - start) * s;
  const double t = between.w / (s * end.w);
  const bool is_finite = end.w / start.w > 0.0;
  return {{origin, divided(between) - origin},
          {0.0, is_finite ? t : std::numeric_limits<double>::infinity()}};
}

ViewRay moved(ViewRay view_ray, const glm::dvec3& by) {
  view_ray.ray.origin += by;
  return view_ray;
}

bool is_translation(const glm::dmat4& matrix) {
  glm::dmat4 rest = matrix;
  rest[3] = {0, 0, 0, matrix[3].w};
  return rest == glm::dmat4(1.0);
}

/// The planes whose distances are the clip coordinates x, y, w, z and w - z, before all stages but the first
/// `left_out`. w - z is taken in the last stage, where it is exact, and not of the product, where z and w may
/// differ by less than their rounding.
struct ClipPlanes {
  glm::dvec4 x{1, 0, 0, 0}, y{0, 1, 0, 0}, w{0, 0, 0, 1}, near{0, 0, 1, 0}, far{0, 0, -1, 1};

  ClipPlanes(const StageList& stages, std::size_t left_out) {
    for (std::size_t i = stages.size(); i-- > left_out;) {
      for (glm::dvec4* plane : {&x, &y, &w, &near, &far}) *plane = *plane * stages[i].matrix;
    }
    scale({&x, &y, &w});
    scale({&near, &far});
  }

  /// Keeps products of three of them in the range of double.
  static void scale(std::initializer_list<glm::dvec4*> planes) {
    double largest = 0.0;
    for (const glm::dvec4* plane : planes) {
      for (int i = 0; i < 4; ++i) largest = std::max(largest, std::fabs((*plane)[i]));
    }
    for (glm::dvec4* plane : planes) *plane /= largest;
  }
};

}  // namespace

CameraRays::CameraRays(const ViewingTransform& viewing, const Viewport& viewport) : viewport_(viewport) {
  const FloatingPointScope floating_point;
  const StageList& stages = viewing.stages();
  const bool is_centred = stages.size() > 1 && is_translation(stages[0].matrix);
  if (is_centred) centre_ = glm::dvec3(0.0) - glm::dvec3(stages[0].matrix[3]);
  const ClipPlanes plane(stages, is_centred ? 1 : 0);
  // The planes x - ndc.x·w and y - ndc.y·w meet in the ray; each coordinate is once in the product, so the
  // place where the ray meets a third plane is a linear function of the ndc.
  near_ = {-kernel(plane.w, plane.y, plane.near), -kernel(plane.x, plane.w, plane.near),
           kernel(plane.x, plane.y, plane.near)};
  // Here w is the determinant of x, y, far, w: the negative of that of x, y, near, w.
  far_ = {kernel(plane.w, plane.y, plane.far), kernel(plane.x, plane.w, plane.far),
          -kernel(plane.x, plane.y, plane.far)};
}

glm::dvec4 CameraRays::point_at(const PlanePoints& columns, const glm::dvec2& ndc) {
  return (columns[0] * ndc.x + columns[1] * ndc.y) + columns[2];
}

ViewRay CameraRays::through(double px, double py) const {
  const glm::dvec2 ndc = viewport_.ndc_from_pixel(px, py);
  const glm::dvec4 near = point_at(near_, ndc);
  const glm::dvec4 far = point_at(far_, ndc);
  if (std::fabs(near.w) >= std::fabs(far.w)) return moved(from_to(near, far), centre_);
  // Started where the numbers are smaller, and turned about: t ≤ 0.
  const ViewRay back = moved(from_to(far, near), centre_);
  return {{back.ray.origin, -back.ray.direction}, {-back.range.upper, 0.0}};
}

}  // namespace velum
