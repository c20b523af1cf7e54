#pragma once

#include <cstdint>

namespace velum {

/// A ScreenTriangle as the vector kernels read it: plain numbers, one cache line.
struct alignas(64) RasterTriangle {
  std::int32_t x[3];  ///< 1/256 pixel; clockwise as seen on the picture, with area
  std::int32_t y[3];
  float r_ref;  ///< the DepthPlane, field by field
  float dx;
  float dy;
  std::int32_t x_ref;
  std::int32_t y_ref;
  float lower;
  float upper;
  std::uint32_t primitive;
};

}  // namespace velum
