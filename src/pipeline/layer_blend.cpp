#include "layer_blend.hpp"

namespace velum {

bool add_behind(const glm::vec4& colour, glm::vec4& front) {
  const float alpha = colour.w > 0.0f ? (colour.w < 1.0f ? colour.w : 1.0f) : 0.0f;
  const float share = (1.0f - front.w) * alpha;
  front = glm::vec4(glm::vec3(front) + glm::vec3(colour) * share, front.w + share);
  return alpha < 1.0f;
}

Rgba8 over_background(const glm::vec4& front, const glm::vec4& background) {
  const float behind = (1.0f - front.w) * background.w;
  const float alpha = front.w + behind;
  const glm::vec3 premultiplied = glm::vec3(front) + glm::vec3(background) * behind;
  const glm::vec3 straight = alpha > 0.0f ? premultiplied / alpha : glm::vec3(0.0f);
  return srgb_from_linear(glm::vec4(straight, alpha));
}

}  // namespace velum
