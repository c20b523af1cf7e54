#include "screen_primitives.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace velum {
namespace {

void append_fragments(const std::array<SnappedVertex, 3>& v, const ScreenTriangle& triangle,
                      const PixelBox& box, const TileGrid& grid, ScreenPrimitives& out) {
  for (int y = box.top; y <= box.bottom; ++y) {
    for (int x = box.left; x <= box.right; ++x) {
      if ((EdgeFunction::between(v[0], v[1], x, y).value | EdgeFunction::between(v[1], v[2], x, y).value |
           EdgeFunction::between(v[2], v[0], x, y).value) < 0) {
        continue;
      }
      const int pixel = tile_place((x - grid.target.left) % tile_size, (y - grid.target.top) % tile_size);
      const auto tile = static_cast<std::uint32_t>(grid.at(x, y));
      const FragmentArrays next = out.fragments.from(out.fragment_count++);
      *next.place = tile * fragment_places + static_cast<std::uint32_t>(pixel);
      *next.depth = std::bit_cast<std::int32_t>(triangle.depth.at(x, y));
      *next.primitive = triangle.primitive;
    }
  }
}

SmallTriangle small_triangle(const std::array<SnappedVertex, 3>& v, const ScreenTriangle& triangle,
                             const PixelBox& box) {
  const DepthPlane& depth = triangle.depth;
  const auto narrow = [](std::int32_t value) { return static_cast<std::int16_t>(value); };
  SmallTriangle out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const SnappedVertex& from = v[i];
    const SnappedVertex& to = v[i == 2 ? 0 : i + 1];
    out.edge[i] =
        static_cast<std::int32_t>(EdgeFunction::between(from, to, box.left, box.top).value >> subpixel_bits);
    out.step_x[i] = narrow(from.y - to.y);
    out.step_y[i] = narrow(to.x - from.x);
  }
  out.left = narrow(box.left), out.top = narrow(box.top);
  out.right = narrow(box.right), out.bottom = narrow(box.bottom);
  out.r_ref = depth.r_ref, out.dx = depth.dx, out.dy = depth.dy;
  out.lower = depth.lower, out.upper = depth.upper;
  out.x_ref = narrow(depth.x_ref), out.y_ref = narrow(depth.y_ref);
  out.primitive = triangle.primitive;
  return out;
}

SmallBounds small_bounds(const PixelBox& box, float nearest, const Rect& target) {
  const auto block = [](int pixel) { return static_cast<std::uint16_t>(pixel / block_size); };
  return {block(box.left - target.left), block(box.top - target.top), block(box.right - target.left),
          block(box.bottom - target.top), nearest};
}

RasterTriangle large_triangle(const std::array<SnappedVertex, 3>& v, const ScreenTriangle& triangle) {
  const DepthPlane& depth = triangle.depth;
  return {{v[0].x, v[1].x, v[2].x},
          {v[0].y, v[1].y, v[2].y},
          depth.r_ref,
          depth.dx,
          depth.dy,
          depth.x_ref,
          depth.y_ref,
          depth.lower,
          depth.upper,
          triangle.primitive};
}

}  // namespace

void ScreenPrimitives::clear() {
  large_count = small_count = ready_count = fragment_count = 0;
  sources.clear();
  box = {};
}

std::uint64_t ScreenPrimitives::bytes() const {
  return large_count * sizeof(RasterTriangle) + ready_count * sizeof(SmallTriangle) +
         small_count * (sizeof(SmallBounds) + sizeof(std::uint32_t)) +
         fragment_count * sizeof(RasterFragment);
}

void ScreenPrimitives::make_room(std::size_t triangles) {
  large.make_room(large_count + triangles, large_count);
  small_bounds.make_room(small_count + triangles + bounds_room, small_count);
  small_refs.make_room(small_count + triangles + bounds_room, small_count);
  fragments.make_room(fragment_count + fragments_room(triangles), fragment_count);
}

PixelBox centres_in_box(const std::int32_t (&x)[3], const std::int32_t (&y)[3], const Rect& target) {
  const auto [x_min, x_max] = std::minmax({x[0], x[1], x[2]});
  const auto [y_min, y_max] = std::minmax({y[0], y[1], y[2]});
  constexpr std::int32_t half = subpixels / 2;
  return {std::max((x_min + half - 1) >> subpixel_bits, target.left),
          std::max((y_min + half - 1) >> subpixel_bits, target.top),
          std::min((x_max - half) >> subpixel_bits, target.right() - 1),
          std::min((y_max - half) >> subpixel_bits, target.bottom() - 1)};
}

bool is_small(const std::array<SnappedVertex, 3>& v, std::int64_t area) {
  const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
  if (x_max - x_min >= small_extent || y_max - y_min >= small_extent) return false;
  const std::int32_t turn = std::abs(v[1].x - v[0].x) + std::abs(v[1].y - v[0].y) +
                            std::abs(v[2].x - v[0].x) + std::abs(v[2].y - v[0].y);
  return std::abs(area) > turn + turned_margin;
}

bool append_triangle(const ScreenTriangle& triangle, const TileGrid& grid, ScreenPrimitives& out) {
  const std::int64_t area = doubled_area(triangle.vertices);
  if (area == 0) return false;
  std::array<SnappedVertex, 3> v = triangle.vertices;
  const bool small = is_small(v, area);
  if (area < 0) std::swap(v[1], v[2]);
  const PixelBox box = centres_in_box({v[0].x, v[1].x, v[2].x}, {v[0].y, v[1].y, v[2].y}, grid.target);
  if (box.is_empty()) return true;
  out.make_room(1);
  if (!small) {
    out.large[out.large_count++] = large_triangle(v, triangle);
  } else if (box.right - box.left < tiny_size && box.bottom - box.top < tiny_size) {
    append_fragments(v, triangle, box, grid, out);
  } else {
    out.make_room_for_ready(1);
    out.small_bounds[out.small_count] = small_bounds(box, triangle.depth.upper, grid.target);
    out.small_refs[out.small_count++] = ready_small | static_cast<std::uint32_t>(out.ready_count);
    out.small[out.ready_count++] = small_triangle(v, triangle, box);
  }
  out.box = united(out.box, box);
  return true;
}

}  // namespace velum
