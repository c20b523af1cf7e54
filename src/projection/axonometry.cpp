#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "../base/error.hpp"
#include "../base/floating_point.hpp"
#include "checks.hpp"
#include "projection.hpp"

// Pohlke 1853: any three segments from one point of a plane, not all on a line, are a parallel picture of
// three equal, perpendicular segments. Found here by writing the 2×3 picture matrix as A = λ·[I | s]·R with a
// rotation R, a shear s and a scale λ: then A Aᵀ = λ²·(I + s sᵀ), so λ² is the smaller eigenvalue of A Aᵀ,
// and s lies along the other eigenvector with |s|² = μ₁/λ² - 1.

namespace velum::projection {
namespace {

struct Pictures {
  glm::dvec3 x, y;  // the rows of A: where the three unit axes go in the picture's x and y
};

struct Factors {
  double scale;
  glm::dvec2 shear;
  glm::dvec3 right, up, back;  // the rows of R
};

Pictures pictures_of_axes(const std::array<double, 3>& angles, const std::array<double, 3>& scales) {
  constexpr const char* names[] = {"x", "y", "z"};
  Pictures a{};
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    check_finite(angles[axis], std::string("angle of ") + names[axis]);
    check_finite(scales[axis], std::string("scale of ") + names[axis]);
    if (std::abs(angles[axis]) > 2.0 * pi + 1e-12 || scales[axis] < 0.0) {
      throw Error(ErrorKind::usage,
                  std::string("the picture of the axis ") + names[axis] + " is out of range", "axonometry",
                  "angles are between -360 and 360 degrees, scales not negative");
    }
    a.x[i] = scales[axis] * elementary::cos(angles[axis]);
    a.y[i] = scales[axis] * elementary::sin(angles[axis]);
  }
  return a;
}

// R and the rest for one of the two shears ±s that give the same picture.
Factors complete(const Pictures& a, const glm::dvec3& normal, double scale, double larger,
                 const glm::dvec2& s) {
  // R·n̂ = (-s, 1)/√(1+|s|²), because A·n = 0; and A·r₃ = λ·s, because r₁, r₂ ⟂ r₃.
  const glm::dvec3 in_rows = (a.x * s.x + a.y * s.y) * (scale / larger);
  const glm::dvec3 back = in_rows + normal / std::sqrt(1.0 + glm::dot(s, s));
  return {scale, s, a.x / scale - s.x * back, a.y / scale - s.y * back, back};
}

double largest_component(const glm::dvec3& v) {
  const glm::dvec3 a = glm::abs(v);
  return glm::max(a.x, glm::max(a.y, a.z));
}

// Unit eigenvector of the larger eigenvalue of [α γ; γ β], δ = √((α-β)² + 4γ²) apart, without cancellation.
glm::dvec2 major_axis(double alpha, double beta, double gamma, double delta) {
  const glm::dvec2 v = alpha >= beta ? glm::dvec2(alpha - beta + delta, 2.0 * gamma)
                                     : glm::dvec2(2.0 * gamma, beta - alpha + delta);
  return v / std::sqrt(glm::dot(v, v));
}

Factors factorise(const Pictures& a) {
  const double alpha = glm::dot(a.x, a.x);
  const double beta = glm::dot(a.y, a.y);
  const double gamma = glm::dot(a.x, a.y);
  const double delta = std::sqrt((alpha - beta) * (alpha - beta) + 4.0 * gamma * gamma);
  const double larger = 0.5 * (alpha + beta + delta);
  const glm::dvec3 normal = glm::cross(a.x, a.y);
  const double area = std::sqrt(glm::dot(normal, normal));
  if (!(area > 1e-9 * larger) || !std::isfinite(larger)) {
    throw Error(ErrorKind::usage, "the pictures of the three axes lie on one line", "axonometry",
                "give at least two axes different directions, with scales above 0");
  }
  const double scale = area / std::sqrt(larger);  // λ² = αβ-γ² over μ₁ = |x × y|² / μ₁
  const double squared_shear = delta / (scale * scale);
  if (squared_shear < 4e-15) return complete(a, normal / area, scale, larger, glm::dvec2(0.0));
  const glm::dvec2 s = major_axis(alpha, beta, gamma, delta) * std::sqrt(squared_shear);
  const Factors plus = complete(a, normal / area, scale, larger, s);
  const Factors minus = complete(a, normal / area, scale, larger, -s);
  // Both give the same picture; the one that looks more squarely at a face is the cabinet kind of camera.
  return largest_component(minus.back) > largest_component(plus.back) ? minus : plus;
}

}  // namespace

Projection axonometry(const std::array<double, 3>& angles, const std::array<double, 3>& scales) {
  const FloatingPointScope floating_point;
  const Factors factors = factorise(pictures_of_axes(angles, scales));
  Projection result;
  result.name = "axonometry";
  result.family = ProjectionFamily::axonometry;
  result.look = -factors.back;
  result.up = factors.up;
  result.to_eye = factors.back;
  result.shear = factors.shear;
  return result;
}

}  // namespace velum::projection
