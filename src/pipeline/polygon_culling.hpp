#pragma once

#include <algorithm>

#include "../base/hierarchy_counters.hpp"
#include "../visibility/depth_format.hpp"
#include "../visibility/raster_triangle.hpp"
#include "../visibility/screen_triangle.hpp"
#include "../visibility/z_pyramid.hpp"

namespace velum {

/// One coordinate of a triangle's corners, 1/256 pixel: the pixels first … last have their centres between
/// the smallest and the largest.
struct CornerCoordinates {
  std::int32_t a, b, c;
  int first() const { return (std::min({a, b, c}) + subpixels / 2 - 1) >> subpixel_bits; }
  int last() const { return (std::max({a, b, c}) - subpixels / 2) >> subpixel_bits; }
};

/// The pixels around a triangle, counted from the target's first.
inline Rect pixels_of(const CornerCoordinates& x, const CornerCoordinates& y, const Rect& target) {
  const int left = x.first(), top = y.first();
  const Rect whole{left - target.left, top - target.top, x.last() - left + 1, y.last() - top + 1};
  return intersect(whole, {0, 0, target.width, target.height});
}
inline Rect pixels_of(const ScreenTriangle& triangle, const Rect& target) {
  const auto& v = triangle.vertices;
  return pixels_of({v[0].x, v[1].x, v[2].x}, {v[0].y, v[1].y, v[2].y}, target);
}

/// Asks the z-pyramid about single polygons, from its coarsest level down, quadrant by quadrant.
class PolygonCulling {
 public:
  /// @param target  the part of the picture that the pyramid stands for
  PolygonCulling(const ZPyramid& pyramid, const Rect& target, DepthFormat format)
      : pyramid_(pyramid), target_(target), format_(format) {}

  /// Whether nothing of the triangle can be seen; counts, unless it covers nothing anyway.
  bool is_hidden(const ScreenTriangle& triangle, HierarchyCounters& counters) const {
    const Rect pixels = pixels_of(triangle, target_);
    if (pixels.is_empty() || doubled_area(triangle.vertices) == 0) return false;
    return is_hidden(pixels, triangle.depth, counters);
  }
  bool is_hidden(const RasterTriangle& t, HierarchyCounters& counters) const {
    return is_hidden(pixels_of({t.x[0], t.x[1], t.x[2]}, {t.y[0], t.y[1], t.y[2]}, target_),
                     {t.r_ref, t.dx, t.dy, t.x_ref, t.y_ref, t.lower, t.upper}, counters);
  }
  bool is_hidden(const SmallTriangle& t, HierarchyCounters& counters) const {
    return is_hidden({t.left - target_.left, t.top - target_.top, t.right - t.left + 1, t.bottom - t.top + 1},
                     {t.r_ref, t.dx, t.dy, t.x_ref, t.y_ref, t.lower, t.upper}, counters);
  }

 private:
  bool is_hidden(const Rect& rect, const DepthPlane& plane, HierarchyCounters& counters) const {
    // Monotone, so that the nearest depth as stored is that of the nearest depth.
    const PyramidAnswer answer = format_ == DepthFormat::reversed
                                     ? pyramid_.is_hidden(rect, plane, target_.left, target_.top)
                                     : pyramid_.is_hidden(rect, stored_depth(format_, plane.upper));
    ++counters.polygons_tested;
    if (!answer.is_hidden) return false;
    ++counters.polygons_hidden;
    ++counters.polygons_hidden_at[answer.level];
    return true;
  }

  const ZPyramid& pyramid_;
  const Rect target_;
  const DepthFormat format_;
};

}  // namespace velum
