#include "visibility/scanline.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <set>
#include <vector>

#include "random.hpp"
#include "visibility/triangulation.hpp"
#include "visibility/zbuffer.hpp"

using namespace velum;

namespace {

using Soup = std::vector<ScreenTriangle>;

/// The number of pixels whose bits differ.
int differences(const VisibilityBuffer& a, const VisibilityBuffer& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const bool same = std::bit_cast<std::uint32_t>(a.reversed_depth.at(x, y)) ==
                            std::bit_cast<std::uint32_t>(b.reversed_depth.at(x, y)) &&
                        a.primitive.at(x, y) == b.primitive.at(x, y);
      count += !same;
    }
  }
  return count;
}

int covered(const VisibilityBuffer& buffer) {
  int count = 0;
  for (int y = 0; y < buffer.height(); ++y) {
    for (int x = 0; x < buffer.width(); ++x) count += buffer.primitive.at(x, y) != no_primitive;
  }
  return count;
}

/// Both methods over one rectangle of the picture, in two calls each: the same buffers, the same counts of
/// what both count. Returns the pixels that are covered.
int check_identity(const Soup& soup, const Rect& rect, DepthFormat format = DepthFormat::reversed) {
  VisibilityBuffer expected(rect.width, rect.height), actual(rect.width, rect.height);
  const std::span<const ScreenTriangle> all(soup);
  const std::size_t half = soup.size() / 2;
  ScanlineTables tables;
  for (const auto& part : {all.first(half), all.subspan(half)}) {
    const RasterCounts wanted = rasterize_zbuffer(part, {expected, rect, nullptr, format});
    const RasterCounts counts =
        rasterize_scanline(part, {actual, rect, nullptr, format}, ZInterpolation::plane, tables);
    CHECK(counts.fragments == wanted.fragments);
    CHECK(counts.fragments_written == wanted.fragments_written);
    CHECK(counts.zero_area == wanted.zero_area);
  }
  CHECK(differences(expected, actual) == 0);
  return covered(expected);
}

/// What lies behind the first layer, pixel by pixel, with a 0 after each: from lists in parts of at most
/// `most` fragments, filled by `raster(target)`.
template <typename Raster>
std::vector<std::uint64_t> listed(const Rect& rect, VisibilityBuffer& front, DepthFormat format,
                                  std::uint64_t most, const Raster& raster) {
  FragmentLists lists;
  lists.begin_counting(front, rect, rect);
  raster(RasterTarget{front, rect, &lists, format});
  std::vector<std::vector<std::uint64_t>> of_pixel(static_cast<std::size_t>(rect.width * rect.height));
  for (const Rect& part : lists.parts(most)) {
    lists.begin_storing(part);
    raster(RasterTarget{front, part, &lists, format});
    lists.sort();
    for (int y = part.top; y < part.bottom(); ++y) {
      for (int x = part.left; x < part.right(); ++x) {
        const std::span<const std::uint64_t> list = lists.at(x, y);
        of_pixel[static_cast<std::size_t>((y - rect.top) * rect.width + x - rect.left)].assign(
            list.begin(), std::find(list.begin(), list.end(), 0u));
      }
    }
  }
  std::vector<std::uint64_t> all;
  for (std::vector<std::uint64_t>& list : of_pixel) {
    all.insert(all.end(), list.begin(), list.end());
    all.push_back(0);
  }
  return all;
}

/// The oracle: every triangle drawn alone, its fragments sorted, the first of each pixel left out.
std::vector<std::uint64_t> sorted_fragments(const Soup& soup, const Rect& rect, DepthFormat format) {
  std::vector<std::set<std::uint64_t, std::greater<>>> of_pixel(
      static_cast<std::size_t>(rect.width * rect.height));
  for (const ScreenTriangle& triangle : soup) {
    VisibilityBuffer alone(rect.width, rect.height);
    rasterize_zbuffer({&triangle, 1}, {alone, rect, nullptr, format});
    for (std::size_t i = 0; i < of_pixel.size(); ++i) {
      const int x = static_cast<int>(i) % rect.width, y = static_cast<int>(i) / rect.width;
      if (alone.primitive.at(x, y) == no_primitive) continue;
      of_pixel[i].insert(nearness(alone.reversed_depth.at(x, y), triangle.primitive));
    }
  }
  std::vector<std::uint64_t> all;
  for (const auto& list : of_pixel) {
    if (!list.empty()) all.insert(all.end(), std::next(list.begin()), list.end());
    all.push_back(0);
  }
  return all;
}

/// Both methods list the same fragments behind the first layer, in parts of any size.
void check_lists(const Soup& soup, const Rect& rect, DepthFormat format = DepthFormat::reversed) {
  VisibilityBuffer front(rect.width, rect.height);
  rasterize_zbuffer(soup, {front, rect, nullptr, format});
  const std::vector<std::uint64_t> expected = sorted_fragments(soup, rect, format);
  const auto by_zbuffer = [&](const RasterTarget& target) { rasterize_zbuffer(soup, target); };
  const auto by_scanline = [&](const RasterTarget& target) { rasterize_scanline(soup, target); };
  CHECK(listed(rect, front, format, 1u << 20, by_zbuffer) == expected);
  CHECK(listed(rect, front, format, 7, by_zbuffer) == expected);
  CHECK(listed(rect, front, format, 300, by_scanline) == expected);
}

/// A depth plane such as a triangle might have; now and then the same for many, so that depths tie.
DepthPlane random_plane(Random& random, int size) {
  DepthPlane plane;
  plane.upper = 1.0f;
  if (random.below(4) == 0) {
    plane.r_ref = 0.5f;
    return plane;
  }
  plane.x_ref = random.below(size);
  plane.y_ref = random.below(size);
  plane.r_ref = static_cast<float>(random.uniform());
  plane.dx = static_cast<float>(random.uniform(-0.02, 0.02));
  plane.dy = static_cast<float>(random.uniform(-0.02, 0.02));
  return plane;
}

/// A depth plane that reaches neither 0 nor 1 in 64 pixels.
DepthPlane gentle_plane(Random& random) {
  DepthPlane plane;
  plane.upper = 1.0f;
  plane.r_ref = 0.5f;
  plane.x_ref = random.below(64);
  plane.y_ref = random.below(64);
  plane.dx = static_cast<float>(random.uniform(-0.003, 0.003));
  plane.dy = static_cast<float>(random.uniform(-0.003, 0.003));
  return plane;
}

/// A coordinate in a picture of `size` pixels: anywhere, on a whole pixel, or on a centre.
std::int32_t random_coordinate(Random& random, int size) {
  const std::int32_t anywhere = random.below(size * subpixels + 1);
  switch (random.below(3)) {
    case 0:
      return anywhere / subpixels * subpixels;
    case 1:
      return random.below(size) * subpixels + subpixels / 2;
    default:
      return anywhere;
  }
}

/// Large, sub-pixel, sliver and collapsed triangles.
ScreenTriangle random_triangle(Random& random, int width, int height) {
  ScreenTriangle triangle;
  const auto vertex = [&] {
    return SnappedVertex{random_coordinate(random, width), random_coordinate(random, height)};
  };
  triangle.vertices = {vertex(), vertex(), vertex()};
  const auto near_first = [&](int reach) {
    const SnappedVertex& v = triangle.vertices[0];
    return SnappedVertex{v.x + random.below(reach) - reach / 2, v.y + random.below(reach) - reach / 2};
  };
  switch (random.below(5)) {
    case 0:  // smaller than a pixel
      triangle.vertices[1] = near_first(300);
      triangle.vertices[2] = near_first(300);
      break;
    case 1:  // a sliver
      triangle.vertices[1] = near_first(20);
      break;
    case 2:  // upright or level edges
      triangle.vertices[1].x = triangle.vertices[0].x;
      triangle.vertices[2].y = triangle.vertices[random.next() & 1u].y;
      break;
    default:
      break;
  }
  triangle.depth = random_plane(random, width);
  return triangle;
}

Soup random_soup(Random& random, int count, int width, int height) {
  Soup soup;
  for (int i = 0; i < count; ++i) {
    soup.push_back(random_triangle(random, width, height));
    soup.back().primitive = static_cast<std::uint32_t>((i * 7919) % count);
  }
  return soup;
}

Rect random_rect(Random& random, int width, int height) {
  const int left = random.below(width), top = random.below(height);
  return {left, top, 1 + random.below(width - left), 1 + random.below(height - top)};
}

void check_soups(int count, std::uint64_t seed) {
  Random random{seed};
  int blank = 0;
  for (int i = 0; i < count; ++i) {
    CAPTURE(i);
    const int width = 8 + random.below(60), height = 8 + random.below(60);
    const Soup soup = random_soup(random, 5 + random.below(60), width, height);
    blank += check_identity(soup, {0, 0, width, height}) == 0;
    check_lists(soup, {0, 0, width, height});
    check_identity(soup, random_rect(random, width, height));
  }
  CHECK(blank <= count / 100);
}

void check_triangulations(int count, std::uint64_t seed) {
  Random random{seed};
  for (int i = 0; i < count; ++i) {
    CAPTURE(i);
    constexpr int size = 48;
    Triangulation mesh =
        jittered_grid(random, 3 + random.below(16), size, i % 3 == 0 ? 0.7 : 0.45, i % 2 == 0);
    for (ScreenTriangle& triangle : mesh.triangles) triangle.depth = random_plane(random, size);
    CHECK(check_identity(mesh.triangles, {0, 0, size, size}) == size * size);
    check_identity(mesh.triangles, random_rect(random, size, size));
  }
}

SnappedVertex at(double x, double y) {
  return {static_cast<std::int32_t>(x * subpixels), static_cast<std::int32_t>(y * subpixels)};
}

}  // namespace

TEST_CASE("scanline and z-buffer agree to the bit on seeded soups, cropped and peeled") {
  check_soups(60, 11);
}

TEST_CASE("scanline and z-buffer agree to the bit on seeded planar triangulations") {
  check_triangulations(40, 12);
}

TEST_CASE("[long] scanline and z-buffer agree to the bit, many more") {
  check_soups(2000, 13);
  check_triangulations(1000, 14);
}

TEST_CASE("scanline and z-buffer agree in the widest and tallest pictures") {
  constexpr int side = 32768;
  Random random{15};
  Soup wide = random_soup(random, 24, side, 16);
  Soup tall = random_soup(random, 24, 16, side);
  CHECK(check_identity(wide, {0, 0, side, 16}) > 0);
  CHECK(check_identity(tall, {0, 0, 16, side}) > 0);
  // The whole 32768² picture as two triangles, seen through its corners and its middle.
  Soup huge(2);
  huge[0].vertices = {at(0, 0), at(side, 0), at(0, side)};
  huge[1].vertices = {at(side, side), at(0, side), at(side, 0)};
  huge[1].primitive = 1;
  for (ScreenTriangle& triangle : huge) triangle.depth = random_plane(random, side);
  for (const Rect& rect : {Rect{0, 0, 32, 32}, Rect{side - 32, 0, 32, 32}, Rect{0, side - 32, 32, 32},
                           Rect{side - 32, side - 32, 32, 32}, Rect{16370, 16370, 32, 32}}) {
    CHECK(check_identity(huge, rect) == 32 * 32);
  }
}

TEST_CASE("coordinates up to 2^23 outside the picture do not overflow") {
  constexpr std::int32_t far_away = 1 << 23;
  Random random{16};
  Soup soup;
  for (std::uint32_t i = 0; i < 40; ++i) {
    ScreenTriangle triangle;
    for (SnappedVertex& v : triangle.vertices) {
      v = {random.below(2 * far_away + 1) - far_away, random.below(2 * far_away + 1) - far_away};
    }
    triangle.depth = random_plane(random, 64);
    triangle.primitive = i;
    soup.push_back(triangle);
  }
  CHECK(check_identity(soup, {0, 0, 64, 64}) > 0);
  check_lists(soup, {0, 0, 64, 64});
  CHECK(check_identity(soup, {16000, 9000, 68, 68}) > 0);
}

TEST_CASE("a span runs from the first centre at or right of its left edge up to its right edge") {
  // A square between centres: left and top edges own their points, right and bottom edges do not.
  Soup square(2);
  square[0].vertices = {at(1.5, 1.5), at(3.5, 1.5), at(3.5, 3.5)};
  square[1].vertices = {at(1.5, 1.5), at(3.5, 3.5), at(1.5, 3.5)};
  square[1].primitive = 1;
  VisibilityBuffer buffer(5, 5);
  const RasterCounts counts = rasterize_scanline(square, {buffer, {0, 0, 5, 5}});
  CHECK(counts.fragments == 4);
  CHECK(counts.pixels_tested == 4);
  CHECK(counts.spans == 3);  // row 1: the lower triangle has a corner only
  CHECK(buffer.primitive.at(1, 1) == 0);
  CHECK(buffer.primitive.at(1, 2) == 1);
  CHECK(buffer.primitive.at(2, 2) == 0);
  CHECK(buffer.primitive.at(3, 1) == no_primitive);
  CHECK(buffer.primitive.at(1, 3) == no_primitive);
}

TEST_CASE("the smallest triangle there is covers a centre if its top left corner is there, and only then") {
  // All three edge values are 0 at the centre of pixel (2, 2), the least that counts as inside.
  constexpr std::int32_t centre = 2 * subpixels + subpixels / 2;
  for (const std::int32_t shift : {0, 1}) {
    Soup one(1);
    one[0].vertices = {SnappedVertex{centre + shift, centre}, SnappedVertex{centre + shift + 1, centre},
                       SnappedVertex{centre + shift, centre + 1}};
    CHECK(check_identity(one, {0, 0, 4, 4}) == 1 - shift);
  }
}

TEST_CASE("triangles without area on the pixel grid are counted, not drawn") {
  Soup flat(3);
  flat[0].vertices = {at(1, 1), at(3, 3), at(5, 5)};
  flat[1].vertices = {at(2, 2), at(2, 2), at(2, 2)};
  flat[2].vertices = {at(0, 2.5), at(4, 2.5), at(8, 2.5)};
  VisibilityBuffer buffer(8, 8);
  const RasterCounts counts = rasterize_scanline(flat, {buffer, {0, 0, 8, 8}});
  CHECK(counts.zero_area == 3);
  CHECK(counts.fragments == 0);
  CHECK(covered(buffer) == 0);
}

TEST_CASE("every depth format is the same for both methods, peeled too") {
  Random random{17};
  for (const DepthFormat format :
       {DepthFormat::float_z, DepthFormat::z24, DepthFormat::z16, DepthFormat::z8}) {
    const Soup soup = random_soup(random, 40, 40, 40);
    check_identity(soup, {0, 0, 40, 40}, format);
    check_identity(soup, {5, 7, 20, 30}, format);
    check_lists(soup, {5, 7, 20, 30}, format);
  }
}

TEST_CASE("interpolated depths cover the same pixels, stay close to the plane and differ somewhere") {
  Random random{18};
  for (const ZInterpolation mode : {ZInterpolation::edges, ZInterpolation::incremental}) {
    int different = 0;
    for (int i = 0; i < 100; ++i) {
      ScreenTriangle triangle = random_triangle(random, 64, 64);
      triangle.depth = gentle_plane(random);
      const std::span<const ScreenTriangle> one(&triangle, 1);
      VisibilityBuffer plane(64, 64), other(64, 64);
      rasterize_scanline(one, {plane, {0, 0, 64, 64}});
      rasterize_scanline(one, {other, {0, 0, 64, 64}}, mode);
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
          REQUIRE(plane.primitive.at(x, y) == other.primitive.at(x, y));
          if (plane.primitive.at(x, y) == no_primitive) continue;
          const float difference = plane.reversed_depth.at(x, y) - other.reversed_depth.at(x, y);
          CHECK(std::abs(difference) < 2e-5f);
          different += difference != 0.0f;
        }
      }
    }
    CHECK(different > 0);
  }
}
