#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "base/ray.hpp"
#include "random.hpp"

/// Seeded points and rays for the tests of ray casting.
inline glm::dvec3 random_point(Random& random, double reach = 1.0) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// Between two points of a cube, a direction of any length.
inline velum::Ray random_ray(Random& random, double reach = 2.0) {
  const glm::dvec3 origin = random_point(random, reach);
  return {origin, (random_point(random) - origin) * random.uniform(0.1, 10.0)};
}
