#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "../projection/viewport.hpp"

namespace velum {

/// The reversed depth r = 1 - z of a triangle as a function of the pixel, in float32, in one written-down
/// order:
///   r = (r_ref + dx·(x - x_ref)) + dy·(y - y_ref), clamped to [lower, upper].
/// Every visibility method evaluates exactly this, so equal ids mean equal depth bits. No NaN, never
/// negative, never -0.
struct DepthPlane {
  float r_ref = 0.0f;
  float dx = 0.0f;
  float dy = 0.0f;
  std::int32_t x_ref = 0;  ///< pixel, centre at +0.5
  std::int32_t y_ref = 0;
  float lower = 0.0f;
  float upper = 0.0f;

  float at(int x, int y) const {
    const float r = (r_ref + dx * static_cast<float>(x - x_ref)) + dy * static_cast<float>(y - y_ref);
    return r < lower ? lower : (r > upper ? upper : r);
  }
};

}  // namespace velum
