#include <doctest/doctest.h>

#include "visibility/triangulation.hpp"
#include "visibility/zbuffer.hpp"

using namespace velum;

namespace {

/// How often each pixel is covered, and with which sign in sum.
struct Coverage {
  Image<int> count, signed_count;
};

Coverage coverage_of(const Triangulation& mesh, int size) {
  Coverage coverage{Image<int>(size, size), Image<int>(size, size)};
  for (const ScreenTriangle& triangle : mesh.triangles) {
    VisibilityBuffer buffer(size, size);
    ScreenTriangle nearest = triangle;
    nearest.depth.r_ref = nearest.depth.upper = nearest.depth.lower = 1.0f;
    const std::array<ScreenTriangle, 1> one{nearest};
    const auto& v = triangle.vertices;
    const int left = std::max(0, std::min({v[0].x, v[1].x, v[2].x}) / subpixels - 1);
    const int right = std::min(size, std::max({v[0].x, v[1].x, v[2].x}) / subpixels + 2);
    const int top = std::max(0, std::min({v[0].y, v[1].y, v[2].y}) / subpixels - 1);
    const int bottom = std::min(size, std::max({v[0].y, v[1].y, v[2].y}) / subpixels + 2);
    const Rect rect{left, top, right - left, bottom - top};
    if (rect.is_empty()) continue;
    buffer.clear(rect.width, rect.height);
    rasterize_zbuffer(one, {buffer, rect});
    const int sign = doubled_area(v) > 0 ? 1 : -1;
    for (int y = 0; y < rect.height; ++y) {
      for (int x = 0; x < rect.width; ++x) {
        if (buffer.primitive.at(x, y) == no_primitive) continue;
        coverage.count.at(left + x, top + y) += 1;
        coverage.signed_count.at(left + x, top + y) += sign;
      }
    }
  }
  return coverage;
}

void check_watertight(int meshes, std::uint64_t seed) {
  Random random{seed};
  constexpr int size = 64;
  int sliver_meshes = 0;
  for (int i = 0; i < meshes; ++i) {
    const bool whole = i % 2 == 0;
    const double jitter = i % 5 == 4 ? 0.7 : 0.45;
    const Triangulation mesh = jittered_grid(random, 3 + random.below(22), size, jitter, whole);
    sliver_meshes += mesh.reversed > 0;
    const Coverage coverage = coverage_of(mesh, size);
    int holes = 0, doubles = 0, wrong_sign = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        holes += coverage.count.at(x, y) < 1;
        doubles += coverage.count.at(x, y) > 1;
        wrong_sign += coverage.signed_count.at(x, y) != 1;
      }
    }
    CAPTURE(i);
    CHECK(holes == 0);
    CHECK(wrong_sign == 0);
    if (mesh.reversed == 0) CHECK(doubles == 0);
  }
  CHECK(sliver_meshes > 0);  // both kinds occurred
  CHECK(sliver_meshes < meshes);
}

}  // namespace

TEST_CASE(
    "planar triangulations are watertight: no hole, signed coverage one, doubles only where snapping "
    "reversed a sliver") {
  check_watertight(100, 1);
}

TEST_CASE("[long] planar triangulations are watertight, many more") {
  check_watertight(2000, 2);
}

TEST_CASE("a centre on an edge belongs to the triangle whose top or left edge it is") {
  // The square (1.5, 1.5)…(3.5, 3.5): its top and left edges run through centres, its right and bottom edges
  // too.
  const auto at = [](double x, double y) {
    return SnappedVertex{static_cast<std::int32_t>(x * subpixels), static_cast<std::int32_t>(y * subpixels)};
  };
  ScreenTriangle upper, lower;
  upper.vertices = {at(1.5, 1.5), at(3.5, 1.5), at(3.5, 3.5)};
  lower.vertices = {at(1.5, 1.5), at(3.5, 3.5), at(1.5, 3.5)};
  upper.primitive = 0;
  lower.primitive = 1;
  VisibilityBuffer buffer(5, 5);
  const std::array<ScreenTriangle, 2> both{upper, lower};
  const RasterCounts counts = rasterize_zbuffer(both, {buffer, {0, 0, 5, 5}});
  CHECK(counts.fragments == 4);
  CHECK(buffer.primitive.at(1, 1) == 0);  // on the shared diagonal: left edge of the upper triangle
  CHECK(buffer.primitive.at(2, 1) == 0);
  CHECK(buffer.primitive.at(1, 2) == 1);
  CHECK(buffer.primitive.at(2, 2) == 0);
  CHECK(buffer.primitive.at(3, 1) == no_primitive);
  CHECK(buffer.primitive.at(1, 3) == no_primitive);
}

TEST_CASE(
    "of two equal depths the lower id is seen, in either order; at z = 1 a fragment beats the background") {
  ScreenTriangle triangle;
  triangle.vertices = {SnappedVertex{0, 0}, SnappedVertex{0, 1024}, SnappedVertex{1024, 0}};
  ScreenTriangle other = triangle;
  triangle.primitive = 7;
  other.primitive = 3;
  VisibilityBuffer first(4, 4), second(4, 4);
  const std::array<ScreenTriangle, 2> ab{triangle, other}, ba{other, triangle};
  rasterize_zbuffer(ab, {first, {0, 0, 4, 4}});
  rasterize_zbuffer(ba, {second, {0, 0, 4, 4}});
  CHECK(first.primitive.at(0, 0) == 3);
  CHECK(second.primitive.at(0, 0) == 3);
  CHECK(first.reversed_depth.at(0, 0) == 0.0f);
}
