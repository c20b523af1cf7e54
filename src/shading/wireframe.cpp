#include "wireframe.hpp"

namespace velum {

glm::vec4 wireframe_ink(const glm::vec4& below) {
  // Rec. 709 luminance; 0.18 linear is the middle grey of sRGB.
  const float luminance = 0.2126f * below.r + 0.7152f * below.g + 0.0722f * below.b;
  const float ink = luminance > 0.18f || below.a < 0.5f ? 0.0f : 1.0f;
  return {ink, ink, ink, 1.0f};
}

}  // namespace velum
