#pragma once

#include <utility>

#include "screen_triangle.hpp"

// The three sources of depth along a span (ZInterpolation); private to scanline_reference.cpp. Each is made
// for one span and asked for its pixels one after the other, from the first to the last.

namespace velum {

inline float clamped(float r, const DepthPlane& plane) {
  return r < plane.lower ? plane.lower : (r > plane.upper ? plane.upper : r);
}

/// The plane, evaluated afresh at each pixel.
class PlaneDepth {
 public:
  PlaneDepth(const ScreenTriangle& triangle, int row, int /*first*/) : plane_(triangle.depth), row_(row) {}
  float at(int x) { return plane_.at(x, row_); }

 private:
  const DepthPlane& plane_;
  int row_;
};

/// The lecture's incremental way: one addition per pixel. Rounding errors add up along the span.
class IncrementalDepth {
 public:
  IncrementalDepth(const ScreenTriangle& triangle, int row, int first)
      : plane_(triangle.depth), r_(plane_.at(first, row)) {}
  float at(int /*x*/) {
    const float r = clamped(r_, plane_);
    r_ += plane_.dx;
    return r;
  }

 private:
  const DepthPlane& plane_;
  float r_;
};

/// The lecture's interpolation: from the vertices along the two edges that the row crosses, then from edge to
/// edge along the span.
class EdgeDepth {
 public:
  EdgeDepth(const ScreenTriangle& triangle, int row, int /*first*/) : plane_(triangle.depth) {
    const std::int64_t centre = std::int64_t{row} * subpixels + subpixels / 2;
    Crossing* crossing = &left_;
    for (std::size_t i = 0; i < 3; ++i) {
      SnappedVertex a = triangle.vertices[i];
      SnappedVertex b = triangle.vertices[(i + 1) % 3];
      if (a.y > b.y) std::swap(a, b);
      if (centre < a.y || centre >= b.y) continue;
      *crossing = cross(a, b, centre);
      crossing = &right_;
    }
    if (right_.x < left_.x) std::swap(left_, right_);
  }

  float at(int x) {
    const float width = right_.x - left_.x;
    if (!(width > 0.0f)) return left_.r;
    const float along = (static_cast<float>(x) + 0.5f - left_.x) / width;
    return clamped(left_.r + along * (right_.r - left_.r), plane_);
  }

 private:
  /// Where an edge meets the row: position in pixels and depth.
  struct Crossing {
    float x = 0.0f;
    float r = 0.0f;
  };

  static float in_pixels(std::int32_t snapped) { return static_cast<float>(snapped) / subpixels; }

  /// The plane's depth at a vertex, which seldom is a pixel centre.
  float depth_at(const SnappedVertex& vertex) const {
    const float x = in_pixels(vertex.x) - 0.5f - static_cast<float>(plane_.x_ref);
    const float y = in_pixels(vertex.y) - 0.5f - static_cast<float>(plane_.y_ref);
    return clamped(plane_.r_ref + plane_.dx * x + plane_.dy * y, plane_);
  }

  Crossing cross(const SnappedVertex& upper, const SnappedVertex& lower, std::int64_t centre) const {
    const float along = static_cast<float>(centre - upper.y) / static_cast<float>(lower.y - upper.y);
    const float upper_r = depth_at(upper);
    return {in_pixels(upper.x) + along * in_pixels(lower.x - upper.x),
            upper_r + along * (depth_at(lower) - upper_r)};
  }

  const DepthPlane& plane_;
  Crossing left_;
  Crossing right_;
};

}  // namespace velum
