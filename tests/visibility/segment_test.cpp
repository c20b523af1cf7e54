#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "random.hpp"
#include "visibility/depth_line.hpp"
#include "visibility/screen_segment.hpp"
#include "visibility/zbuffer.hpp"

using namespace velum;

namespace {

constexpr int side = 48;
using Pixels = std::set<std::pair<int, int>>;

SnappedVertex at(double x, double y) {
  return {static_cast<std::int32_t>(x * subpixels), static_cast<std::int32_t>(y * subpixels)};
}

Pixels drawn(const std::vector<ScreenTriangle>& triangles, std::uint64_t* fragments = nullptr) {
  VisibilityBuffer buffer(side, side);
  const RasterCounts counts = rasterize_zbuffer(triangles, {buffer, {0, 0, side, side}});
  if (fragments) *fragments = counts.fragments;
  Pixels pixels;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (buffer.primitive.at(x, y) != no_primitive) pixels.emplace(x, y);
    }
  }
  return pixels;
}

ScreenTriangle prototype() {
  ScreenTriangle triangle;
  triangle.depth.r_ref = triangle.depth.upper = 0.5f;
  return triangle;
}

Pixels segment(const SnappedVertex& a, const SnappedVertex& b, float width = 1.0f,
               std::uint64_t* fragments = nullptr) {
  std::vector<ScreenTriangle> triangles;
  append_segment(a, b, width, prototype(), triangles);
  return drawn(triangles, fragments);
}

/// The rule read column by column (row by row), in whole numbers: one whose centre is in [start, end) has the
/// centres within half a width of the line. Of the two ends of that range one belongs to it, as the top-left
/// rule has it: in a row the left one; in a column the upper where the line is level or rises to the right,
/// the lower where it falls.
Pixels columns_of(SnappedVertex a, SnappedVertex b, int width) {
  const bool x_major = is_x_major(a, b);
  if (!x_major) {
    std::swap(a.x, a.y);
    std::swap(b.x, b.y);
  }
  if (b.x < a.x) std::swap(a, b);
  Pixels pixels;
  const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
  for (int column = 0; column < side; ++column) {
    const std::int64_t centre = column * subpixels + subpixels / 2;
    if (centre < a.x || centre >= b.x) continue;
    for (int row = 0; row < side; ++row) {
      // How far the centre is below the line, times dx.
      const std::int64_t below = (row * subpixels + subpixels / 2 - a.y) * dx - (centre - a.x) * dy;
      const std::int64_t half = static_cast<std::int64_t>(width) * (subpixels / 2) * dx;
      const bool is_inside = below > -half && below < half;
      const bool is_owned_end = !x_major || dy <= 0 ? below == -half : below == half;
      if (!is_inside && !is_owned_end) continue;
      pixels.insert(x_major ? std::pair{column, row} : std::pair{row, column});
    }
  }
  return pixels;
}

}  // namespace

TEST_CASE("a segment's pixels in all eight octants, the same in both directions") {
  const SnappedVertex centre = at(10.5, 10.5);
  const std::array<std::pair<int, int>, 8> octants{
      {{4, 1}, {1, 4}, {-1, 4}, {-4, 1}, {-4, -1}, {-1, -4}, {1, -4}, {4, -1}}};
  for (const std::pair<int, int>& step : octants) {
    const int dx = step.first, dy = step.second;
    const SnappedVertex end = at(10.5 + dx, 10.5 + dy);
    const Pixels pixels = segment(centre, end);
    CAPTURE(dx);
    CAPTURE(dy);
    CHECK(pixels.size() == 4);
    CHECK(pixels == segment(end, centre));
    CHECK(pixels == columns_of(centre, end, 1));
  }
  // Right and down: from the pixel of one end up to, not including, that of the other; the middle column's
  // centre is as far from both rows, and a falling line takes the lower.
  CHECK(segment(centre, at(14.5, 11.5)) == Pixels{{10, 10}, {11, 10}, {12, 11}, {13, 11}});
  CHECK(segment(centre, at(14.5, 9.5)) == Pixels{{10, 10}, {11, 10}, {12, 9}, {13, 9}});
  CHECK(segment(centre, at(10.5, 13.5)) == Pixels{{10, 10}, {10, 11}, {10, 12}});
  CHECK(segment(centre, at(7.5, 10.5)) == Pixels{{7, 10}, {8, 10}, {9, 10}});
  CHECK(segment(centre, centre).empty());
  CHECK(segment(at(3.6, 3.5), at(4.4, 3.5)).empty());  // between two centres
}

TEST_CASE("10,000 random segments equal the rule read column by column in whole numbers") {
  Random random{31};
  for (int i = 0; i < 10000; ++i) {
    // Every third on half pixels, where ties are.
    const auto coordinate = [&] {
      return i % 3 == 0 ? random.below(2 * side) * 128 : random.below(side * subpixels);
    };
    const SnappedVertex a{coordinate(), coordinate()};
    SnappedVertex b{coordinate(), coordinate()};
    if (i % 7 == 0) b = {a.x + b.x / 64, a.y + b.y / 64};  // short ones
    const int width = 1 + i % 4;
    std::uint64_t fragments = 0;
    const Pixels pixels = segment(a, b, static_cast<float>(width), &fragments);
    if (pixels != columns_of(a, b, width) || fragments != pixels.size()) {
      CAPTURE(a.x);
      CAPTURE(a.y);
      CAPTURE(b.x);
      CAPTURE(b.y);
      CHECK(pixels == columns_of(a, b, width));
      CHECK(fragments == pixels.size());  // no centre twice: the two halves share no pixel
    }
  }
}

TEST_CASE("each column has exactly the width, and a polyline draws its joints once") {
  Random random{5};
  for (int i = 0; i < 200; ++i) {
    const float width = static_cast<float>(1 + i % 5);
    std::vector<ScreenTriangle> triangles;
    SnappedVertex from = at(2, 24);
    for (int x = 5; x <= 44; x += 3) {
      const SnappedVertex to{x * subpixels + random.below(200), from.y + random.below(600) - 300};
      append_segment(from, to, width, prototype(), triangles);
      from = to;
    }
    std::uint64_t fragments = 0;
    const Pixels pixels = drawn(triangles, &fragments);
    CHECK(fragments == pixels.size());
    std::vector<int> heights(side, 0);
    for (const auto& [x, y] : pixels) ++heights[static_cast<std::size_t>(x)];
    for (int x = 2; x < 44; ++x) CHECK(heights[static_cast<std::size_t>(x)] == static_cast<int>(width));
  }
}

TEST_CASE("a point of whole size s has s x s pixels") {
  Random random{6};
  for (int i = 0; i < 500; ++i) {
    const int size = 1 + i % 6;
    std::vector<ScreenTriangle> triangles;
    const SnappedVertex centre{2000 + random.below(8000), 2000 + random.below(8000)};
    append_point(centre, static_cast<float>(size), prototype(), triangles);
    std::uint64_t fragments = 0;
    const Pixels pixels = drawn(triangles, &fragments);
    CHECK(pixels.size() == static_cast<std::size_t>(size * size));
    CHECK(fragments == pixels.size());
    // Each centre within half a size of the point's, the upper left ends included.
    for (const auto& [x, y] : pixels) {
      const int dx = x * subpixels + subpixels / 2 - centre.x, dy = y * subpixels + subpixels / 2 - centre.y;
      const int half = size * subpixels / 2;
      CHECK((dx >= -half && dx < half && dy >= -half && dy < half));
    }
  }
}

TEST_CASE("a segment's depth is that of the line under the column's centre, whichever way it runs") {
  Random random{7};
  const Viewport viewport{640, 480};
  for (int i = 0; i < 2000; ++i) {
    const auto end = [&] {
      const double w = random.uniform(0.1, 10.0);
      return glm::dvec4(random.uniform(-1, 1) * w, random.uniform(-1, 1) * w, random.uniform(0, 1) * w, w);
    };
    const std::array<glm::dvec4, 2> ends{end(), end()};
    const bool x_major = i % 2 == 0;
    const int axis = x_major ? 0 : 1;
    const DepthPlane plane = depth_line(ends, x_major, viewport);
    const DepthPlane turned = depth_line({ends[1], ends[0]}, x_major, viewport);
    CHECK((plane.r_ref == turned.r_ref && plane.dx == turned.dx && plane.dy == turned.dy));
    const double s0 = ends[0][axis] / ends[0].w, s1 = ends[1][axis] / ends[1].w;
    if (std::abs(s1 - s0) < 1e-3) continue;
    const double r0 = 1 - ends[0].z / ends[0].w, r1 = 1 - ends[1].z / ends[1].w;
    const int pixel = 100 + i % 300;
    const glm::dvec2 centre = viewport.ndc_from_pixel(pixel + 0.5, pixel + 0.5);
    const double expected = r0 + (r1 - r0) * (centre[axis] - s0) / (s1 - s0);
    const double clamped = std::clamp(expected, std::min(r0, r1), std::max(r0, r1));
    const double tolerance = 4e-7 * (1.0 + std::abs((r1 - r0) / (s1 - s0)));
    CHECK(std::abs(double(plane.at(pixel, pixel)) - clamped) < tolerance);
    CHECK(plane.at(x_major ? pixel : 3, x_major ? 3 : pixel) == plane.at(pixel, pixel));
  }
}
