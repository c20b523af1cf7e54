#include "enclosing_ellipsoid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "../base/aabb.hpp"
#include "../base/elementary.hpp"

namespace velum {
namespace {

/// The upper triangular R with Rᵀ·R = m. @pre m is symmetric and positive definite
glm::dmat3 cholesky(const glm::dmat3& m) {
  glm::dmat3 r(0.0);  // r[column][row]
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row <= column; ++row) {
      double rest = m[column][row];
      for (int k = 0; k < row; ++k) rest -= r[column][k] * r[row][k];
      r[column][row] = row == column ? std::sqrt(rest) : rest / r[row][row];
    }
  }
  return r;
}

/// Sum of weight·(p, 1)·(p, 1)ᵀ over points scaled into a cube. Khachiyan's algorithm moves weight, step by
/// step, to the point that is farthest out by the ellipsoid of the weights so far.
glm::dmat4 khachiyan(std::span<const glm::dvec3> points) {
  glm::dmat4 sum(0.0);
  const double share = 1.0 / static_cast<double>(points.size());
  for (const glm::dvec3& p : points) sum += glm::outerProduct(glm::dvec4(p, 1.0), glm::dvec4(p, 1.0)) * share;
  constexpr int steps = 200;
  constexpr double thin = 0x1.0p-30;  // keeps flat points from giving a matrix without an inverse
  for (int i = 0; i < steps; ++i) {
    glm::dmat4 thick = sum;
    for (int axis = 0; axis < 3; ++axis) thick[axis][axis] += thin;
    const glm::dmat4 inverse = glm::inverse(thick);
    double most = 0.0;
    glm::dvec4 farthest(0.0);
    for (const glm::dvec3& p : points) {
      const glm::dvec4 q(p, 1.0);
      const double outside = glm::dot(q, inverse * q);
      if (outside > most) {
        most = outside;
        farthest = q;
      }
    }
    if (!(most > 4.0 * (1.0 + 1e-3))) break;
    const double step = (most - 4.0) / (4.0 * (most - 1.0));
    sum = sum * (1.0 - step) + glm::outerProduct(farthest, farthest) * step;
  }
  return sum;
}

}  // namespace

EnclosingEllipsoid enclosing_ellipsoid(std::span<const glm::vec3> points) {
  Aabb box;
  for (const glm::vec3& p : points) box.include(glm::dvec3(p));
  const glm::dvec3 size = box.size();
  const double largest = std::max({size.x, size.y, size.z, 0x1.0p-100});
  glm::dmat3 scale(1.0);
  for (int axis = 0; axis < 3; ++axis) scale[axis][axis] = 1.0 / std::max(size[axis], 0x1.0p-20 * largest);

  std::vector<glm::dvec3> scaled;
  scaled.reserve(points.size());
  for (const glm::vec3& p : points) scaled.push_back(scale * (glm::dvec3(p) - box.centre()));
  const glm::dmat4 sum = khachiyan(scaled);
  const glm::dvec3 centre(sum[3]);
  glm::dmat3 covariance = glm::dmat3(sum) - glm::outerProduct(centre, centre);
  for (int axis = 0; axis < 3; ++axis) covariance[axis][axis] += 0x1.0p-30;
  const glm::dmat3 ball_from_scaled = cholesky(glm::inverse(covariance));

  EnclosingEllipsoid result{box.centre() + glm::inverse(scale) * centre, ball_from_scaled * scale};
  double radius = 0.0;
  for (const glm::vec3& p : points) {
    radius = std::max(radius, glm::length(result.ball_from_space * (glm::dvec3(p) - result.centre)));
  }
  result.ball_from_space *= 1.0 / (std::max(radius, 0x1.0p-60) * (1.0 + 0x1.0p-45));
  return result;
}

double ellipsoid_area(const glm::dmat3& ball_from_space) {
  // A piece of the sphere with normal n becomes one of |det M|·|M⁻ᵀ·n| times the area.
  constexpr int rows = 128, columns = 128;
  const glm::dmat3 normals = glm::transpose(ball_from_space);
  double sum = 0.0;
  for (int i = 0; i < rows; ++i) {
    const double z = (i + 0.5) / rows, ring = std::sqrt(1.0 - z * z);  // the other half is the same
    for (int k = 0; k < columns; ++k) {
      const double angle = 2.0 * pi * (k + 0.5) / columns;
      const glm::dvec3 n(ring * elementary::cos(angle), ring * elementary::sin(angle), z);
      sum += glm::length(normals * n);
    }
  }
  return sum / (rows * columns) * 4.0 * pi / std::fabs(glm::determinant(ball_from_space));
}

}  // namespace velum
