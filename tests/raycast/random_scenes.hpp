#pragma once

#include <limits>
#include <vector>

#include "random_rays.hpp"
#include "raycast/triangle_set.hpp"

/// Triangles and rays that are hard on structures over space: many in one plane or point, on whole numbers,
/// of all sizes, without area, not finite.
struct RandomTriangles {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;

  velum::TriangleSet set() const { return {positions, triangles}; }

  void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triangles.emplace_back(first, first + 1, first + 2);
  }
};

/// Points at random, on whole numbers, in a plane, on a line, or in few places.
inline glm::vec3 random_corner(Random& random, int kind) {
  const auto whole = [&] { return static_cast<float>(random.below(9) - 4) * 0.25f; };
  glm::vec3 p(random_point(random));
  if (kind == 1) p = {whole(), whole(), whole()};
  if (kind == 2) p.z = 0.5f;
  if (kind == 3) p = {whole(), 0.25f, 0.25f};
  if (kind == 4) p = {whole(), whole(), 0.0f};
  return p;
}

inline RandomTriangles random_triangles(Random& random, int scene) {
  RandomTriangles result;
  const int counts[] = {0, 1, 2, 3, 10, 40, 120, 400};
  const int count = counts[random.below(scene % 10 == 0 ? 8 : 7)];
  const int kinds = 1 + random.below(6);  // scenes of one kind and mixed ones
  for (int i = 0; i < count; ++i) {
    const int kind = kinds == 6 ? random.below(5) : kinds - 1;
    const glm::vec3 a = random_corner(random, kind);
    const float size = random.below(3) == 0 ? 1.0f : (random.below(2) == 0 ? 0.25f : 0.01f);
    glm::vec3 b = random_corner(random, kind), c = random_corner(random, kind);
    if (kind == 0) {
      b = a + (b - a) * size;
      c = a + (c - a) * size;
    }
    result.add(a, b, c);
    if (random.below(20) == 0) result.triangles.push_back(result.triangles.back());  // the same twice
    if (random.below(40) == 0) result.add(a, a, b);                                  // no area
    if (random.below(40) == 0) result.add(a, b, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
    if (random.below(40) == 0) result.add(a, b, glm::vec3(std::numeric_limits<float>::infinity(), 0, 0));
  }
  return result;
}

/// A ray that something may happen to, aimed at or along a triangle, axis, edge or corner as often as not.
inline velum::Ray hard_ray(Random& random, const RandomTriangles& scene) {
  velum::Ray ray = random_ray(random);
  const int kind = random.below(12);
  if (kind == 0) ray.direction[random.below(3)] = 0.0;
  if (kind == 1) ray = {glm::dvec3(random_corner(random, 1)), glm::dvec3(0.0)};
  if (kind == 1) ray.direction[random.below(3)] = random.below(2) == 0 ? 2.0 : -0.5;
  if (kind == 2) ray = {glm::dvec3(random_corner(random, 1)), glm::dvec3(random_corner(random, 1))};
  if (kind == 3) ray.origin *= 1e3;
  if (kind == 4) ray.origin *= 1e9;
  if (kind == 5 && random.below(8) == 0) ray.direction.x = std::numeric_limits<double>::quiet_NaN();
  if (kind == 5 && random.below(8) == 0) ray.direction = glm::dvec3(0.0);
  if (kind < 6 || scene.triangles.empty()) return ray;
  const glm::uvec3 t =
      scene.triangles[static_cast<std::size_t>(random.below(static_cast<int>(scene.triangles.size())))];
  const glm::dvec3 a(scene.positions[t.x]), b(scene.positions[t.y]), c(scene.positions[t.z]);
  const double along = random.uniform();
  if (kind == 6) ray.direction = a - ray.origin;                              // through a corner
  if (kind == 7) ray.direction = a + (b - a) * 0.5 - ray.origin;              // through an edge
  if (kind == 8) ray = {a + (b - a) * along, c - a};                          // in the plane
  if (kind == 9) ray = {a - (b - a) * along, b - a};                          // along an edge
  if (kind == 10) ray.direction = a * 0.5 + b * 0.2 + c * 0.3 - ray.origin;   // inside
  if (kind == 11) ray = {a * 0.5 + b * 0.2 + c * 0.3, random_point(random)};  // starts on it
  return ray;
}
