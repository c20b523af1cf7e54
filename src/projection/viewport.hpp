#pragma once

#include <glm/vec2.hpp>

namespace velum {

/// Canonical x, y in [-1, 1] → pixels: (0,0) is the top left corner, y down, centres at +0.5.
/// x' = W/2·(x+1), y' = H/2·(1-y). (The lecture floors and has y up; see docs/conventions.md.)
struct Viewport {
  int width = 0;
  int height = 0;

  glm::dvec2 pixel_from_ndc(double x, double y) const {
    return {0.5 * width * (x + 1.0), 0.5 * height * (1.0 - y)};
  }
  glm::dvec2 ndc_from_pixel(double px, double py) const {
    return {2.0 * px / width - 1.0, 1.0 - 2.0 * py / height};
  }
};

}  // namespace velum
