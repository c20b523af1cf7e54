#include "sample_resolve.hpp"

#include <glm/vec3.hpp>

#include "../visibility/sample_positions.hpp"

namespace velum {
namespace {

/// NaN becomes 0.
float clamped(float value, float most) {
  return value > 0.0f ? (value < most ? value : most) : 0.0f;
}

glm::vec4 showable(const glm::vec4& premultiplied) {
  const float alpha = clamped(premultiplied.w, 1.0f);
  return {clamped(premultiplied.x, alpha), clamped(premultiplied.y, alpha), clamped(premultiplied.z, alpha),
          alpha};
}

}  // namespace

glm::dvec2 centroid_of(std::uint32_t samples, int count) {
  if (samples == all_samples(count)) return glm::dvec2(0.0);
  std::int32_t x = 0, y = 0, n = 0;
  for (const SamplePosition& position : sample_positions(count)) {
    if (samples & 1u) {
      x += position.x;
      y += position.y;
      ++n;
    }
    samples >>= 1;
  }
  const double scale = static_cast<double>(subpixels) * n;
  return {x / scale, y / scale};
}

glm::vec4 with_behind(const glm::vec4& front, const glm::vec4& colour) {
  const float share = (1.0f - front.w) * clamped(colour.w, 1.0f);
  return {glm::vec3(front) + glm::vec3(colour) * share, front.w + share};
}

Rgba8 resolved(glm::vec4* samples, int count) {
  for (int i = 0; i < count; ++i) samples[i] = showable(samples[i]);
  for (int half = count / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) samples[i] += samples[i + half];
  }
  const glm::vec4 mean = samples[0] / static_cast<float>(count);
  const glm::vec3 straight = mean.w > 0.0f ? glm::vec3(mean) / mean.w : glm::vec3(0.0f);
  return srgb_from_linear(glm::vec4(straight, mean.w));
}

}  // namespace velum
