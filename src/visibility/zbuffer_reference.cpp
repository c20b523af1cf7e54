#include <algorithm>

#include "zbuffer.hpp"

namespace velum {
namespace {

/// The first pixel whose centre is at or right of (below) a snapped coordinate.
constexpr int first_centre(std::int32_t snapped) {
  return (snapped - subpixels / 2 + subpixels - 1) >> subpixel_bits;
}
/// The last pixel whose centre is at or left of (above) a snapped coordinate.
constexpr int last_centre(std::int32_t snapped) {
  return (snapped - subpixels / 2) >> subpixel_bits;
}

/// The pixels whose centres lie in the triangle's box.
Rect pixel_box(const std::array<SnappedVertex, 3>& v) {
  const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
  const int left = first_centre(x_min);
  const int top = first_centre(y_min);
  return {left, top, last_centre(x_max) - left + 1, last_centre(y_max) - top + 1};
}

/// Keeps the nearer of the fragment and what the buffer holds.
template <DepthFormat format>
void compare_and_write(const ScreenTriangle& triangle, int x, int y, const RasterTarget& target,
                       RasterCounts& counts) {
  const float r = stored_depth<format>(triangle.depth.at(x, y));
  ++counts.fragments;
  if (target.lists != nullptr) return target.lists->add(x, y, r, triangle.primitive);
  const int column = x - target.rect.left;
  const int row = y - target.rect.top;
  float& buffer_r = target.buffer.reversed_depth.at(column, row);
  std::uint32_t& buffer_id = target.buffer.primitive.at(column, row);
  if (is_nearer(r, triangle.primitive, buffer_r, buffer_id)) {
    buffer_r = r;
    buffer_id = triangle.primitive;
    ++counts.fragments_written;
  }
}

template <DepthFormat format>
void rasterize(const ScreenTriangle& triangle, const RasterTarget& target, RasterCounts& counts) {
  std::array<SnappedVertex, 3> v = triangle.vertices;
  const std::int64_t area = doubled_area(v);
  if (area == 0) {
    ++counts.zero_area;
    return;
  }
  if (area < 0) std::swap(v[1], v[2]);

  const Rect box = intersect(pixel_box(v), target.rect);
  if (box.is_empty()) return;
  EdgeFunction edges[3] = {EdgeFunction::between(v[0], v[1], box.left, box.top),
                           EdgeFunction::between(v[1], v[2], box.left, box.top),
                           EdgeFunction::between(v[2], v[0], box.left, box.top)};
  counts.pixels_tested += static_cast<std::uint64_t>(box.width) * static_cast<std::uint64_t>(box.height);
  for (int y = box.top; y < box.bottom(); ++y) {
    std::int64_t e0 = edges[0].value;
    std::int64_t e1 = edges[1].value;
    std::int64_t e2 = edges[2].value;
    for (int x = box.left; x < box.right(); ++x) {
      if ((e0 | e1 | e2) >= 0) compare_and_write<format>(triangle, x, y, target, counts);
      e0 += edges[0].step_x;
      e1 += edges[1].step_x;
      e2 += edges[2].step_x;
    }
    for (EdgeFunction& edge : edges) edge.value += edge.step_y;
  }
}

}  // namespace

RasterCounts rasterize_zbuffer(std::span<const ScreenTriangle> triangles, const RasterTarget& target) {
  RasterCounts counts;
  with_format(target.format, [&](auto format) {
    for (const ScreenTriangle& triangle : triangles) rasterize<format.value>(triangle, target, counts);
  });
  return counts;
}

}  // namespace velum
