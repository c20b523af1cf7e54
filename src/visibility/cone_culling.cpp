#include "cone_culling.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace velum {
namespace {

glm::dvec4 row(const glm::dmat4& m, int i) {
  return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

double determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::dot(a, glm::cross(b, c));
}

/// The vector that is orthogonal to three: their generalised cross product.
glm::dvec4 orthogonal(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
  const auto minor = [&](int i, int j, int k) {
    return determinant({a[i], a[j], a[k]}, {b[i], b[j], b[k]}, {c[i], c[j], c[k]});
  };
  return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

double length(const glm::dvec3& v) {
  return std::sqrt(glm::dot(v, v));
}

}  // namespace

ConeCulling::ConeCulling(const BoxProjection& projection) : projection_(projection) {
  const glm::dmat4& m = projection.clip_from_object();
  const glm::dvec4 x = row(m, 0), y = row(m, 1), w = row(m, 3);
  eye_ = orthogonal(x, y, w);
  const glm::dvec3 x3(x), y3(y), w3(w);
  stretch_ = std::sqrt(glm::dot(x3, x3) + glm::dot(y3, y3) + glm::dot(w3, w3));
}

bool ConeCulling::has_sign(const NormalCone& cone, const Aabb& box, double sign) const {
  return cone.is_valid && sign * glm::dot(cone.axis, glm::dvec3(eye_) - box.centre() * eye_.w) > 0.0;
}

bool ConeCulling::all_have_sign(const NormalCone& cone, const Aabb& box, double sign) const {
  if (!cone.is_valid) return false;
  const glm::dvec3 view = glm::dvec3(eye_) - box.centre() * eye_.w;
  const double along = sign * glm::dot(cone.axis, view);
  if (!(along > 0.0)) return false;
  // Of all normals in the cone the one farthest from the view vector, at the corner farthest from the middle.
  const double across = std::sqrt(std::max(glm::dot(view, view) - along * along, 0.0));
  const double reach = 0.5 * length(box.size()) * std::abs(eye_.w);
  const double least = along * cone.cosine - across * cone.sine - reach;
  // What the computed determinant o·(ab × ac) may be off by: o and the edges from the transform, and the
  // products. The eye has errors of the same kind, within the 4.
  const glm::dvec4& e = projection_.rounding();
  const double rounding = length({e.x, e.y, e.w});
  const double origin = rounding * 0x1p47;  // the terms' sizes, from which the rounding was made
  const double edge = stretch_ * cone.longest_edge + 2.0 * rounding;
  const double error = 4.0 * (8.0 * rounding * edge * edge + 8.0 * origin * rounding * edge);
  return least * cone.smallest_area > error;
}

}  // namespace velum
