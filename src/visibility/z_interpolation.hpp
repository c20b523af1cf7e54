#pragma once

namespace velum {

/// Where the scanline method takes a pixel's depth from. Only `plane` keeps the promise that every method
/// gives the same bits; the others are for teaching.
enum class ZInterpolation {
  plane,        ///< DepthPlane, evaluated afresh at each pixel
  edges,        ///< linear along the triangle's edges, then linear along the span, in float32
  incremental,  ///< the plane at the span's first pixel, then dz added per pixel, in float32
};

}  // namespace velum
