#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/vec4.hpp>

#include "random.hpp"

/// Seeded clip-space data that meets the hard cases often: small integers (exact ties with the planes),
/// points on planes, w ≤ 0, and widely different magnitudes.
inline glm::dvec4 random_point(Random& random) {
  glm::dvec4 p;
  switch (random.next() % 6) {
    case 0:  // small integers: ties with planes, w = 0, the zero vector
      for (int i = 0; i < 4; ++i) p[i] = static_cast<double>(static_cast<int>(random.next() % 9) - 4);
      return p;
    case 1:  // around the volume, w = 1
      return {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 2), 1.0};
    case 2: {  // exactly on one of the planes
      const double w = random.uniform(0, 2);
      p = {random.uniform(-w, w), random.uniform(-w, w), random.uniform(0, w), w};
      const std::uint64_t plane = random.next() % 6;
      p[static_cast<int>(plane / 2)] = plane % 2 == 1 ? w : (plane / 2 == 2 ? 0.0 : -w);
      return p;
    }
    case 3: {  // within an ulp of one or more planes, inside or outside
      const double w = random.uniform(0, 2);
      p = {random.next() % 2 == 0 ? w : -w, random.next() % 2 == 0 ? w : -w, random.uniform(0, w), w};
      for (int axis = 0; axis < 3; ++axis) {
        if (random.next() % 3 == 0) p[axis] = random.uniform(-3, 3);
        if (random.next() % 2 == 0)
          p[axis] = std::nextafter(p[axis], random.next() % 2 == 0 ? 0.0 : 4.0 * p[axis]);
      }
      return p;
    }
    case 4: {  // any magnitude
      const double scale = static_cast<double>(1ull << (random.next() % 60)) * 0x1p-30;
      for (int i = 0; i < 4; ++i) p[i] = random.uniform(-1, 1) * scale;
      return p;
    }
    default:  // in front of and behind the eye
      return {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-1, 3)};
  }
}

using Triangle = std::array<glm::dvec4, 3>;

inline Triangle random_triangle(Random& random) {
  return {random_point(random), random_point(random), random_point(random)};
}

/// Bit for bit: -0.0 differs from 0.0, and a NaN equals itself.
inline bool same_bits(const glm::dvec4& a, const glm::dvec4& b) {
  for (int i = 0; i < 4; ++i) {
    if (std::memcmp(&a[i], &b[i], sizeof(double)) != 0) return false;
  }
  return true;
}
