#pragma once

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

namespace velum {

inline glm::dvec4 row(const glm::dmat4& matrix, int index) {
  return {matrix[0][index], matrix[1][index], matrix[2][index], matrix[3][index]};
}

/// The vector orthogonal to three 4-vectors: the generalised cross product, by 3×3 cofactors. Of three
/// planes, their common point.
inline glm::dvec4 kernel(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
  const auto minor = [&](int i, int j, int k) {
    return glm::dot(glm::dvec3(a[i], a[j], a[k]),
                    glm::cross(glm::dvec3(b[i], b[j], b[k]), glm::dvec3(c[i], c[j], c[k])));
  };
  return {minor(1, 2, 3), -minor(0, 2, 3), minor(0, 1, 3), -minor(0, 1, 2)};
}

}  // namespace velum
