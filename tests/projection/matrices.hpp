#pragma once

#include <Eigen/Dense>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

// Bridges to Eigen, the oracle of these tests.

inline Eigen::Matrix4d eigen(const glm::dmat4& m) {
  Eigen::Matrix4d result;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) result(row, column) = m[column][row];
  }
  return result;
}
inline Eigen::Vector4d eigen(const glm::dvec4& v) {
  return {v.x, v.y, v.z, v.w};
}
inline Eigen::Vector3d eigen(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

inline Eigen::Matrix4d translation(double x, double y, double z) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<3, 1>(0, 3) = Eigen::Vector3d(x, y, z);
  return m;
}
inline Eigen::Matrix4d scaling(double x, double y, double z) {
  return Eigen::Vector4d(x, y, z, 1.0).asDiagonal();
}

/// The turn into camera axes, derived apart from the library: Gram-Schmidt on (back, up).
inline Eigen::Matrix4d turn(const glm::dvec3& look, const glm::dvec3& up) {
  const Eigen::Vector3d back = -eigen(look).normalized();
  const Eigen::Vector3d y = (eigen(up) - back * back.dot(eigen(up))).normalized();
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<1, 3>(0, 0) = y.cross(back).transpose();
  m.block<1, 3>(1, 0) = y.transpose();
  m.block<1, 3>(2, 0) = back.transpose();
  return m;
}

/// The one-dimensional kernel of a matrix, of unit length.
template <typename Matrix>
Eigen::Vector4d kernel(const Matrix& m) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(m, Eigen::ComputeFullV);
  return svd.matrixV().col(3);
}

inline Eigen::Matrix<double, 3, 4> rows_xyw(const Eigen::Matrix4d& m) {
  Eigen::Matrix<double, 3, 4> rows;
  rows << m.row(0), m.row(1), m.row(3);
  return rows;
}

/// Whether two homogeneous vectors are the same point: equal up to a factor, to `tolerance` of unit length.
inline bool same_up_to_factor(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double tolerance = 1e-12) {
  const Eigen::VectorXd u = a.normalized();
  const Eigen::VectorXd v = b.normalized();
  return (u - v).norm() <= tolerance || (u + v).norm() <= tolerance;
}

/// The canonical point of a world point.
inline glm::dvec3 canonical(const glm::dmat4& clip_from_world, const glm::dvec3& point) {
  const glm::dvec4 clip = clip_from_world * glm::dvec4(point, 1.0);
  return glm::dvec3(clip) / clip.w;
}
