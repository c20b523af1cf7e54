#include "wireframe.hpp"

#include <glm/vec3.hpp>

namespace velum {

glm::vec4 over_wireframe(const glm::vec4& colour, float edge_distance) {
  if (!(edge_distance < 1.0f)) return colour;
  const float line = 1.0f - edge_distance;
  // Rec. 709 luminance; 0.18 linear is the middle grey of sRGB. Where nothing opaque lies below, black.
  const float luminance = 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b;
  const float ink = luminance > 0.18f || colour.a < 0.5f ? 0.0f : 1.0f;
  // Porter & Duff 1984, "over", with straight alpha.
  const float below = colour.a * (1.0f - line);
  const float alpha = line + below;
  if (!(alpha > 0.0f)) return colour;
  return {(glm::vec3(ink) * line + glm::vec3(colour) * below) / alpha, alpha};
}

}  // namespace velum
