#include "visibility/sample_positions.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <set>

#include "random.hpp"
#include "visibility/triangulation.hpp"
#include "visibility/zbuffer.hpp"

using namespace velum;

namespace {

/// Whether the sample at (px, py), in 1/256 pixel, belongs to the triangle: inside, or on a top or left edge.
bool covers(std::array<SnappedVertex, 3> v, std::int32_t px, std::int32_t py) {
  if (doubled_area(v) == 0) return false;
  if (doubled_area(v) < 0) std::swap(v[1], v[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const SnappedVertex& a = v[i];
    const SnappedVertex& b = v[(i + 1) % 3];
    const std::int64_t side = doubled_area({a, b, SnappedVertex{px, py}});
    const bool is_top = a.y == b.y && b.x > a.x;
    const bool is_left = b.y < a.y;
    if (side < 0 || (side == 0 && !is_top && !is_left)) return false;
  }
  return true;
}

/// How many samples of each pixel the triangles cover, each counted as often as it is covered.
Image<int> covered_samples(const std::vector<ScreenTriangle>& triangles, int size, int count) {
  Image<int> sum(size, size);
  for (const SamplePosition& sample : sample_positions(count)) {
    for (ScreenTriangle triangle : triangles) {
      move_to(sample, triangle);
      triangle.depth = {};
      VisibilityBuffer buffer(size, size);
      rasterize_zbuffer({&triangle, 1}, {buffer, {0, 0, size, size}});
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) sum.at(x, y) += buffer.primitive.at(x, y) != no_primitive;
      }
    }
  }
  return sum;
}

ScreenTriangle random_triangle(Random& random, int size) {
  ScreenTriangle t;
  for (SnappedVertex& v : t.vertices) {
    const int unit = random.below(3) != 0 ? 16 : 1;  // edges and corners in the samples themselves
    v = {random.below(size * subpixels / unit) * unit, random.below(size * subpixels / unit) * unit};
  }
  t.depth.r_ref = static_cast<float>(random.uniform());
  t.depth.dx = static_cast<float>(random.uniform(-0.1, 0.1));
  t.depth.dy = static_cast<float>(random.uniform(-0.1, 0.1));
  t.depth.x_ref = random.below(size);
  t.depth.y_ref = random.below(size);
  t.depth.upper = 0.9f;
  t.depth.lower = 0.1f;
  return t;
}

/// A rectangle of two triangles, in 1/256 pixel.
std::vector<ScreenTriangle> rectangle(std::int32_t left, std::int32_t top, std::int32_t right,
                                      std::int32_t bottom) {
  std::vector<ScreenTriangle> halves(2);
  halves[0].vertices = {SnappedVertex{left, top}, {right, top}, {right, bottom}};
  halves[1].vertices = {SnappedVertex{left, top}, {right, bottom}, {left, bottom}};
  return halves;
}

}  // namespace

TEST_CASE("the patterns: so many samples, in the pixel, no two in one row or column") {
  CHECK(sample_positions(1).size() == 1);
  CHECK(sample_positions(1)[0] == pixel_centre);
  for (const int count : {4, 8, 16}) {
    const auto samples = sample_positions(count);
    CHECK(samples.size() == static_cast<std::size_t>(count));
    std::set<int> columns, rows;
    for (const SamplePosition& sample : samples) {
      CHECK((sample.x >= -128 && sample.x < 128 && sample.y >= -128 && sample.y < 128));
      columns.insert(sample.x);
      rows.insert(sample.y);
    }
    CHECK(columns.size() == samples.size());
    CHECK(rows.size() == samples.size());
  }
}

TEST_CASE("a sample is covered exactly if it is inside the snapped triangle, or on a top or left edge") {
  constexpr int size = 12;
  Random random{11};
  int on_edges = 0;
  for (int i = 0; i < 200; ++i) {
    const ScreenTriangle triangle = random_triangle(random, size);
    for (const SamplePosition& sample : sample_positions(16)) {
      ScreenTriangle moved = triangle;
      move_to(sample, moved);
      VisibilityBuffer buffer(size, size);
      rasterize_zbuffer({&moved, 1}, {buffer, {0, 0, size, size}});
      int wrong = 0;
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
          const std::int32_t px = x * subpixels + 128 + sample.x, py = y * subpixels + 128 + sample.y;
          wrong += (buffer.primitive.at(x, y) != no_primitive) != covers(triangle.vertices, px, py);
          for (std::size_t k = 0; k < 3; ++k)
            on_edges += doubled_area({triangle.vertices[k], triangle.vertices[(k + 1) % 3],
                                      SnappedVertex{px, py}}) == 0;
        }
      }
      CHECK(wrong == 0);
    }
  }
  CHECK(on_edges > 100);  // the fill rule was asked
}

TEST_CASE("the depth at a sample is the written-down expression, and at the centre the centre's") {
  Random random{12};
  for (int i = 0; i < 500; ++i) {
    const ScreenTriangle triangle = random_triangle(random, 32);
    const DepthPlane& plane = triangle.depth;
    for (const SamplePosition& sample : sample_positions(8)) {
      ScreenTriangle moved = triangle;
      move_to(sample, moved);
      const int x = random.below(32), y = random.below(32);
      const float along_x = plane.dx * (static_cast<float>(sample.x) / 256.0f);
      const float along_y = plane.dy * (static_cast<float>(sample.y) / 256.0f);
      const float r_ref = plane.r_ref + (along_x + along_y);
      float r = (r_ref + plane.dx * static_cast<float>(x - plane.x_ref)) +
                plane.dy * static_cast<float>(y - plane.y_ref);
      r = std::min(std::max(r, plane.lower), plane.upper);
      CHECK(moved.depth.at(x, y) == r);
      // And it is the plane's depth there, up to float32.
      const double exact = static_cast<double>(plane.r_ref) +
                           plane.dx * (x + sample.x / 256.0 - plane.x_ref) +
                           plane.dy * (y + sample.y / 256.0 - plane.y_ref);
      CHECK(r == doctest::Approx(std::clamp(exact, 0.1, 0.9)).epsilon(1e-5));
    }
    DepthPlane same = plane;
    move_depth(same, pixel_centre);
    CHECK(std::memcmp(&same, &plane, sizeof plane) == 0);
  }
}

TEST_CASE("a triangulation covers every sample of every pixel exactly once") {
  constexpr int size = 24;
  Random random{13};
  for (const int count : {4, 8, 16}) {
    Triangulation mesh = jittered_grid(random, 6, size, 0.25, false);
    REQUIRE(mesh.reversed == 0);
    const Image<int> sum = covered_samples(mesh.triangles, size, count);
    int wrong = 0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) wrong += sum.at(x, y) != count;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("an edge at a multiple of 1/256 pixel covers exactly the samples right of it") {
  for (const int count : {4, 8, 16}) {
    for (std::int32_t left = 0; left <= 256; ++left) {
      int right_of_it = 0;
      for (const SamplePosition& sample : sample_positions(count)) right_of_it += 128 + sample.x >= left;
      const Image<int> sum = covered_samples(rectangle(left, 0, 512, 256), 2, count);
      CHECK(sum.at(0, 0) == right_of_it);
      CHECK(sum.at(1, 0) == count);
      CHECK(sum.at(0, 1) == 0);
    }
    CHECK(covered_samples(rectangle(128, 0, 256, 256), 1, count).at(0, 0) == count / 2);
    CHECK(covered_samples(rectangle(0, 0, 256, 128), 1, count).at(0, 0) == count / 2);
  }
}
