#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "image/visibility_buffer.hpp"
#include "projection/camera.hpp"
#include "scene/scene.hpp"

/// The first oracle: a brute-force ray cast, double precision, from geometry alone. It shares nothing with
/// the pipeline: no matrix, no outcode, no clipping, no raster; rays come from the camera's parameters.
namespace oracle {

struct Hit {
  std::uint32_t primitive = velum::no_primitive;
  double depth = 0.0;           ///< along the look vector, world units
  double reversed_depth = 0.0;  ///< r = 1 - z
};

/// A camera as its parameters say: origin and axes in the world, window half sizes, shear, near and far.
struct Eye {
  bool perspective = true;
  glm::dvec3 position, right, up, back;
  glm::dvec2 window_centre{0.0}, window_half{1.0};  ///< at depth 1 (perspective) or anywhere (parallel)
  glm::dvec2 shear{0.0};
  double focus = 0.0, near = 0.1, far = 1.0;
  int width = 1, height = 1;

  Eye(const velum::Camera& camera, int width_in, int height_in) : width(width_in), height(height_in) {
    const velum::Pose& pose = camera.pose();
    position = pose.position;
    back = -glm::normalize(pose.look);
    right = glm::normalize(glm::cross(pose.up, back));
    up = glm::cross(back, right);
    near = camera.near();
    far = camera.far();
    const double aspect = static_cast<double>(width) / height;
    if (const auto* lens = std::get_if<velum::PerspectiveLens>(&camera.lens())) {
      window_half = {aspect, 1.0};
      if (const auto* v = std::get_if<velum::VerticalAngle>(&lens->opening))
        window_half *= std::tan(v->radians / 2);
      if (const auto* h = std::get_if<velum::HorizontalAngle>(&lens->opening))
        window_half *= std::tan(h->radians / 2) / aspect;
      if (const auto* f = std::get_if<velum::FocalLength>(&lens->opening))
        window_half *= 0.5 * f->film_height / f->focal_length;
      window_centre = 2.0 * lens->shift * window_half;
    } else if (const auto* off = std::get_if<velum::OffAxisFrustum>(&camera.lens())) {
      window_half = glm::dvec2(off->right - off->left, off->top - off->bottom) * (0.5 / near);
      window_centre = glm::dvec2(off->right + off->left, off->top + off->bottom) * (0.5 / near);
    } else if (const auto* window = std::get_if<velum::ParallelWindow>(&camera.lens())) {
      perspective = false;
      window_half = glm::dvec2(aspect, 1.0) * (0.5 * window->height);
      shear = window->shear;
      focus = window->focus;
    }
  }

  /// The world point at depth d behind the pixel position (px, py).
  glm::dvec3 at(double px, double py, double d) const {
    const glm::dvec2 ndc(2.0 * px / width - 1.0, 1.0 - 2.0 * py / height);
    const glm::dvec2 on_window = window_centre + ndc * window_half;
    const glm::dvec2 xy = perspective ? on_window * d : on_window + shear * (d - focus);
    return position + right * xy.x + up * xy.y - back * d;
  }
  /// Camera space (x right, y up, depth along the look vector) of a world point.
  glm::dvec3 camera_from(const glm::dvec3& p) const {
    const glm::dvec3 v = p - position;
    return {glm::dot(v, right), glm::dot(v, up), -glm::dot(v, back)};
  }
  /// The pixel position of a camera-space point.
  glm::dvec2 pixel_of(const glm::dvec3& c) const {
    const glm::dvec2 on_window =
        perspective ? glm::dvec2(c.x, c.y) / c.z : glm::dvec2(c.x, c.y) - shear * (c.z - focus);
    const glm::dvec2 ndc = (on_window - window_centre) / window_half;
    return {0.5 * width * (ndc.x + 1.0), 0.5 * height * (1.0 - ndc.y)};
  }
  double reversed_depth(double d) const {
    return perspective ? near * (far - d) / (d * (far - near)) : (far - d) / (far - near);
  }
};

/// The world triangles of a scene, by primitive id.
struct WorldTriangle {
  glm::dvec3 a, b, c;
};

inline std::vector<WorldTriangle> world_triangles(const velum::Scene& scene) {
  std::vector<WorldTriangle> result;
  for (const velum::Instance& instance : scene.instances()) {
    const velum::Mesh& mesh = scene.meshes()[instance.mesh];
    const auto world = [&](std::uint32_t i) {
      return glm::dvec3(instance.world_from_object * glm::dvec4(glm::dvec3(mesh.positions[i]), 1.0));
    };
    for (const glm::uvec3& t : mesh.triangles) result.push_back({world(t.x), world(t.y), world(t.z)});
  }
  return result;
}

/// Where the ray through a pixel position meets a triangle (plane, then the three sides), between near and
/// far.
inline std::optional<double> depth_of_hit(const Eye& eye, const WorldTriangle& t, double px, double py) {
  const glm::dvec3 origin = eye.at(px, py, 0.0);
  const glm::dvec3 direction = eye.at(px, py, 1.0) - origin;  // depth is the ray's parameter
  const glm::dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
  const double slope = glm::dot(normal, direction);
  if (slope == 0.0) return {};
  const double depth = glm::dot(normal, t.a - origin) / slope;
  if (!(depth >= eye.near && depth <= eye.far)) return {};
  const glm::dvec3 p = origin + direction * depth;
  const double u = glm::dot(normal, glm::cross(t.b - t.a, p - t.a));
  const double v = glm::dot(normal, glm::cross(t.c - t.b, p - t.b));
  const double w = glm::dot(normal, glm::cross(t.a - t.c, p - t.c));
  if (!(u >= 0.0 && v >= 0.0 && w >= 0.0)) return {};
  return depth;
}

/// The nearest triangle at a pixel centre.
inline Hit cast(const Eye& eye, const std::vector<WorldTriangle>& triangles, int x, int y) {
  Hit hit;
  for (std::uint32_t id = 0; id < triangles.size(); ++id) {
    const std::optional<double> depth = depth_of_hit(eye, triangles[id], x + 0.5, y + 0.5);
    if (depth && (hit.primitive == velum::no_primitive || *depth < hit.depth)) hit = {id, *depth, 0.0};
  }
  if (hit.primitive != velum::no_primitive) hit.reversed_depth = eye.reversed_depth(hit.depth);
  return hit;
}

}  // namespace oracle
