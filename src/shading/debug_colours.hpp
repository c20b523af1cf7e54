#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "../image/colour.hpp"

namespace velum {

/// The range of metric depths a depth view spreads its greys over, world units.
struct MetricRange {
  double nearest = 0.0;
  double farthest = 1.0;
};

/// Debug views show numbers, not light: 0…1 is meant as the 8-bit sRGB code 0…255 (rounded half up, clamped;
/// NaN is 0). These are the linear colours that are encoded to exactly those codes, alpha 1.
glm::vec4 colour_of_codes(const glm::vec3& values);
/// The codes themselves: what colour_of_codes() is encoded to.
Rgba8 codes_of(const glm::vec3& values);

/// What a debug view shows of a unit normal, (n + 1) / 2, and of a depth: 1 nearest, 0.1 farthest.
inline glm::vec3 normal_values(const glm::vec3& unit_normal) {
  return (unit_normal + 1.0f) * 0.5f;
}
glm::vec3 depth_values(double metric_depth, const MetricRange& range);

/// normal_values(): x, y, z as red, green, blue, in world space.
glm::vec4 normal_colour(const glm::vec3& unit_normal);

/// Nearest white, farthest dark grey (so that it stands out from a black background), linear in metric depth;
/// white for a range without extent.
glm::vec4 depth_colour(double metric_depth, const MetricRange& range);

}  // namespace velum
