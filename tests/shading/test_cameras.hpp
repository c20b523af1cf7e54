#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "random.hpp"
#include "scene/scene.hpp"
#include "shading/triangle_view.hpp"

// Cameras written out by hand from the conventions, so that the tests of shading do not lean on the module
// that makes cameras for the library.

struct TestCamera {
  glm::dmat4 clip_from_world{1.0};
  velum::Viewer viewer;
};

inline glm::dvec3 random_vector(Random& random, double a, double b) {
  const double x = random.uniform(a, b), y = random.uniform(a, b), z = random.uniform(a, b);
  return {x, y, z};
}

inline glm::dmat3 random_rotation(Random& random) {
  const glm::dvec3 right = glm::normalize(random_vector(random, -1, 1));
  const glm::dvec3 up = glm::normalize(glm::cross(right, random_vector(random, -1, 1)));
  return {right, up, glm::cross(right, up)};
}

/// World → camera: columns of `pose` are right, up, back.
inline glm::dmat4 camera_from_world(const glm::dmat3& pose, const glm::dvec3& position) {
  glm::dmat4 m(glm::transpose(pose));
  m[3] = glm::dvec4(-(glm::transpose(pose) * position), 1.0);
  return m;
}

inline glm::dvec4 depth_plane(const glm::dmat3& pose, const glm::dvec3& position) {
  return {-pose[2], glm::dot(pose[2], position)};
}

inline TestCamera perspective_camera(const glm::dmat3& pose, const glm::dvec3& position,
                                     velum::Viewport viewport) {
  const double near = 0.1, far = 50.0, tangent = 0.5, aspect = double(viewport.width) / viewport.height;
  glm::dmat4 clip(0.0);
  clip[0][0] = 1.0 / (tangent * aspect);
  clip[1][1] = 1.0 / tangent;
  clip[2] = {0.0, 0.0, -far / (far - near), -1.0};
  clip[3] = {0.0, 0.0, -near * far / (far - near), 0.0};
  return {clip * camera_from_world(pose, position),
          {viewport, glm::dvec4(position, 1.0), depth_plane(pose, position)}};
}

/// x' = x + shear.x·z, y' = y + shear.y·z; shear 0 is orthographic.
inline TestCamera parallel_camera(const glm::dmat3& pose, const glm::dvec3& position,
                                  velum::Viewport viewport, const glm::dvec2& shear) {
  const double near = 0.1, far = 50.0, half = 3.0, aspect = double(viewport.width) / viewport.height;
  glm::dmat4 clip(1.0);
  clip[0][0] = 1.0 / (half * aspect);
  clip[1][1] = 1.0 / half;
  clip[2] = {shear.x * clip[0][0], shear.y * clip[1][1], -1.0 / (far - near), 0.0};
  clip[3] = {0.0, 0.0, -near / (far - near), 1.0};
  const glm::dvec3 to_viewer = glm::normalize(pose * glm::dvec3(-shear.x, -shear.y, 1.0));
  return {clip * camera_from_world(pose, position),
          {viewport, glm::dvec4(to_viewer, 0.0), depth_plane(pose, position)}};
}

/// Perspective, orthographic and oblique from the same random place.
inline std::array<TestCamera, 3> random_cameras(Random& random, velum::Viewport viewport) {
  const glm::dmat3 pose = random_rotation(random);
  const glm::dvec3 position = pose[2] * random.uniform(1.0, 6.0) + random_vector(random, -0.5, 0.5);
  const glm::dvec2 shear(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8));
  return {perspective_camera(pose, position, viewport),
          parallel_camera(pose, position, viewport, glm::dvec2(0.0)),
          parallel_camera(pose, position, viewport, shear)};
}

inline velum::Mesh triangle_mesh(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  velum::Mesh mesh;
  mesh.positions = {a, b, c};
  mesh.triangles = {glm::uvec3(0, 1, 2)};
  return mesh;
}

inline velum::Mesh random_triangle_mesh(Random& random) {
  const glm::vec3 a = random_vector(random, -2, 2), b = random_vector(random, -2, 2),
                  c = random_vector(random, -2, 2);
  return triangle_mesh(a, b, c);
}

inline velum::TriangleView view_of(const velum::Scene& scene, const TestCamera& camera,
                                   std::uint32_t instance = 0) {
  const glm::dmat4 clip = camera.clip_from_world * scene.instances()[instance].world_from_object;
  return velum::view_triangle(scene, {instance, 0}, clip, camera.viewer);
}
