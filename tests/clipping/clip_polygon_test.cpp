#include "clipping/clip_polygon.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <limits>

#include "base/contract.hpp"
#include "clipping_data.hpp"

using velum::clip_polygon;
using velum::clip_triangle;
using velum::ClippedPolygon;
using velum::ClipPlane;

namespace {

/// Signed area on the divided picture, counter-clockwise positive; the whole picture is 4.
double picture_area(std::span<const glm::dvec4> polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec4 p = polygon[i] / polygon[i].w;
    const glm::dvec4& next = polygon[(i + 1) % polygon.size()];
    const glm::dvec4 q = next / next.w;
    twice += p.x * q.y - p.y * q.x;
  }
  return 0.5 * twice;
}

bool has_vertex(const ClippedPolygon& polygon, const glm::dvec4& vertex) {
  return std::count(polygon.span().begin(), polygon.span().end(), vertex) == 1;
}

unsigned bits(std::initializer_list<ClipPlane> planes) {
  unsigned code = 0;
  for (const ClipPlane plane : planes) code |= 1u << static_cast<unsigned>(plane);
  return code;
}

}  // namespace

TEST_CASE("clip_triangle: inside comes back bit for bit, also with -0.0 and without area") {
  const glm::dvec4 a{-0.0, -1, -0.0, 1}, b{1, 0, 1, 1}, c{0, 0.5, 0.5, 2};
  const ClippedPolygon same = clip_triangle(a, b, c);
  CHECK(same.count == 3);
  CHECK(same.cut_by == 0);
  CHECK(same_bits(same.vertices[0], a));
  CHECK(same_bits(same.vertices[1], b));
  CHECK(same_bits(same.vertices[2], c));
  CHECK(clip_triangle(a, a, b).count == 3);
}

TEST_CASE("clip_triangle: one corner cut off, two corners cut off") {
  const ClippedPolygon quad = clip_triangle({0, 0, 0.5, 1}, {2, 0, 0.5, 1}, {0, 0.5, 0.5, 1});
  CHECK(quad.count == 4);
  CHECK(quad.cut_by == bits({ClipPlane::right}));
  CHECK(has_vertex(quad, {1, 0, 0.5, 1}));
  CHECK(has_vertex(quad, {1, 0.25, 0.5, 1}));
  const ClippedPolygon tip = clip_triangle({0, 0, 0.5, 1}, {2, -0.5, 0.5, 1}, {2, 0.5, 0.5, 1});
  CHECK(tip.count == 3);
  CHECK(has_vertex(tip, {1, -0.25, 0.5, 1}));
  CHECK(has_vertex(tip, {1, 0.25, 0.5, 1}));
}

TEST_CASE("clip_triangle: covers the whole picture with every vertex outside") {
  const ClippedPolygon whole = clip_triangle({-8, -8, 0.5, 1}, {8, -8, 0.5, 1}, {0, 16, 0.5, 1});
  CHECK(whole.count == 4);
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) CHECK(has_vertex(whole, {x, y, 0.5, 1}));
  }
  CHECK(picture_area(whole.span()) == 4.0);
  CHECK(whole.cut_by == bits({ClipPlane::left, ClipPlane::right, ClipPlane::below, ClipPlane::above}));
  // The same with a vertex behind the eye: the sky over a plane that runs away from the camera.
  const ClippedPolygon sloping = clip_triangle({-40, -8, 0.5, 1}, {40, -8, 0.5, 1}, {0, 8, -0.4, -0.5});
  CHECK(sloping.count >= 4);
  CHECK(picture_area(sloping.span()) == doctest::Approx(4.0).epsilon(1e-14));
}

TEST_CASE("clip_triangle: vertices and edges in a plane stay, without duplicates") {
  // An edge in the plane x = w, the third vertex inside, then outside.
  const glm::dvec4 e0{1, -0.5, 0.5, 1}, e1{1, 0.5, 0.5, 1};
  CHECK(clip_triangle(e0, e1, {0, 0, 0.5, 1}).cut_by == 0);
  CHECK(clip_triangle(e0, e1, {2, 0, 0.5, 1}).count == 0);
  // A vertex on a plane, one inside, one outside: a triangle again.
  const ClippedPolygon half = clip_triangle({1, 0, 0.5, 1}, {0, -0.5, 0.5, 1}, {2, 0.75, 0.5, 1});
  CHECK(half.count == 3);
  // A vertex on a plane between two that are outside: nothing.
  CHECK(clip_triangle({1, 0, 0.5, 1}, {2, -0.5, 0.5, 1}, {2, 0.5, 0.5, 1}).count == 0);
  // In the near and far planes altogether, reaching over the sides.
  for (const double z : {0.0, 1.0}) {
    const ClippedPolygon flat = clip_triangle({-8, -8, z, 1}, {8, -8, z, 1}, {0, 16, z, 1});
    CHECK(flat.count == 4);
    CHECK(picture_area(flat.span()) == 4.0);
  }
  // An edge along the volume's own edge x = w, y = w.
  const ClippedPolygon along = clip_triangle({1, 1, -1, 1}, {1, 1, 2, 1}, {0, 0, 0.5, 1});
  CHECK(along.count == 5);
  CHECK(has_vertex(along, {1, 1, 0, 1}));
  CHECK(has_vertex(along, {1, 1, 1, 1}));
}

TEST_CASE("clip_triangle: a corner of the volume pokes through the triangle") {
  // x + y + z = 2.5 for w = 1 cuts the corner (1, 1, 1) off: a triangle with its vertices on three edges.
  const ClippedPolygon corner =
      clip_triangle({10, -3.75, -3.75, 1}, {-3.75, 10, -3.75, 1}, {-3.75, -3.75, 10, 1});
  CHECK(corner.count == 3);
  for (const glm::dvec4& vertex : corner.span()) {
    CHECK(vertex.x + vertex.y + vertex.z == doctest::Approx(2.5));
    CHECK(velum::outcode(vertex) == 0);
  }
}

TEST_CASE("clip_triangle: w ≤ 0") {
  CHECK(clip_triangle({0, 0, -0.5, -1}, {0.5, 0, -0.5, -1}, {0, 0.5, -0.5, -1}).count == 0);
  // One vertex behind the eye: the piece in front, and only that.
  const ClippedPolygon front = clip_triangle({-0.5, 0, 0.5, 1}, {0.5, 0, 0.5, 1}, {0, 0, -1.5, -1});
  CHECK(front.count == 4);
  CHECK(has_vertex(front, {-0.375, 0, 0, 0.5}));
  CHECK(has_vertex(front, {0.375, 0, 0, 0.5}));
  // At infinity (w = 0), and the zero vector, which is no point.
  CHECK(clip_triangle({-0.5, 0, 0.5, 1}, {0.5, 0, 0.5, 1}, {0, 1, 0, 0}).count == 4);
  CHECK(clip_triangle({-0.5, 0, 0.5, 1}, {0.5, 0, 0.5, 1}, {0, 0, 0, 0}).count == 0);
  CHECK(clip_triangle({0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}).count == 0);
}

TEST_CASE("clip_triangle: NaN and infinity give nothing; the largest numbers do not overflow") {
  const glm::dvec4 a{0, 0, 0.5, 1}, b{0.5, 0, 0.5, 1};
  for (int axis = 0; axis < 4; ++axis) {
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      glm::dvec4 c{0, 0.5, 0.5, 1};
      c[axis] = bad;
      CHECK(clip_triangle(a, b, c).count == 0);
      CHECK(clip_triangle(c, a, b).count == 0);
    }
  }
  const double huge = std::numeric_limits<double>::max();
  const ClippedPolygon large =
      clip_triangle({-huge, -huge, 0, huge / 8}, {huge, -huge, 0, huge / 8}, {0, huge, 0, huge / 8});
  CHECK(large.count >= 4);
  for (const glm::dvec4& vertex : large.span()) CHECK(velum::outcode(vertex) == 0);
  CHECK(picture_area(large.span()) == doctest::Approx(4.0).epsilon(1e-14));
}

TEST_CASE("clip_triangle: the camera inside an object sees it on the whole picture") {
  // A cube of half-edge 1 around the eye; near 0.1, far 10, opening 90° both ways: x' = x, y' = y, w' = -z.
  const double near = 0.1, far = 10.0, k = near / far;
  const glm::dmat4 clip_from_eye{
      {1 / far, 0, 0, 0}, {0, 1 / far, 0, 0}, {0, 0, 1 / (k - 1) / far, -1 / far}, {0, 0, k / (k - 1), 0}};
  Random random{11};
  for (int turn = 0; turn < 50; ++turn) {
    // Any linear image of the cube around the eye will do; this one turns and shears it a little.
    glm::dmat4 turned(1.0);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) turned[i][j] += random.uniform(-0.3, 0.3);
    }
    double area = 0.0;
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
      std::array<glm::dvec4, 4> corners;
      for (unsigned i = 0; i < 4; ++i) {
        glm::dvec4 corner{0, 0, 0, 1};
        corner[axis] = face % 2 == 1 ? 1 : -1;
        corner[u] = (i == 1 || i == 2) == (face % 2 == 1) ? 1 : -1;
        corner[v] = i >= 2 ? 1 : -1;
        corners[i] = clip_from_eye * turned * corner;
      }
      area += picture_area(clip_triangle(corners[0], corners[1], corners[2]).span());
      area += picture_area(clip_triangle(corners[0], corners[2], corners[3]).span());
    }
    CHECK(std::abs(area) == doctest::Approx(4.0).epsilon(1e-13));
  }
}

TEST_CASE("clip_polygon: any convex polygon; a triangle as clip_triangle does it") {
  std::vector<glm::dvec4> disc;
  const std::array<glm::dvec2, 3> octant{{{3, 0}, {2.75, 1.25}, {2, 2.25}}};
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (const glm::dvec2& p : octant) {
      const std::array<glm::dvec2, 4> turned{{{p.x, p.y}, {-p.y, p.x}, {-p.x, -p.y}, {p.y, -p.x}}};
      const glm::dvec2 q = turned[static_cast<unsigned>(quarter)];
      disc.emplace_back(q, 0.5, 1);
    }
  }
  CHECK(picture_area(clip_polygon(disc)) == 4.0);
  for (glm::dvec4& p : disc) p *= glm::dvec4(0.375, 0.375, 1, 1);
  const std::vector<glm::dvec4> clipped = clip_polygon(disc);
  CHECK(clipped.size() > 8);
  CHECK(picture_area(clipped) < 4.0);
  CHECK(clip_polygon(clipped) == clipped);

  CHECK(clip_polygon({}).empty());
  std::vector<glm::dvec4> spoilt = disc;
  spoilt[5].y = std::nan("");
  CHECK(clip_polygon(spoilt).empty());
  CHECK(clip_polygon(std::span<const glm::dvec4>(disc.data(), 2)).empty());
  Random random{12};
  for (int i = 0; i < 2000; ++i) {
    const Triangle t = random_triangle(random);
    const ClippedPolygon one = clip_triangle(t[0], t[1], t[2]);
    const std::vector<glm::dvec4> other = clip_polygon(t);
    CHECK(std::equal(one.span().begin(), one.span().end(), other.begin(), other.end(), same_bits));
  }
}

TEST_CASE("clip_against: the steps that clip_triangle takes, one by one") {
  ClippedPolygon polygon{{glm::dvec4{-8, -8, 0.5, 1}, {8, -8, 0.5, 1}, {0, 16, 0.5, 1}}, 3, 0};
  const std::array<int, 6> counts{3, 3, 4, 5, 5, 4};
  for (int i = 0; i < velum::clip_plane_count; ++i) {
    polygon = clip_against(polygon, static_cast<ClipPlane>(i));
    CHECK(polygon.count == counts[static_cast<unsigned>(i)]);
  }
  CHECK(polygon.cut_by == bits({ClipPlane::left, ClipPlane::right, ClipPlane::below, ClipPlane::above}));
  // A vertex on the plane is its own cut point.
  const ClippedPolygon kite{{glm::dvec4{1, 0, 0.5, 1}, {2, 0.5, 0.5, 1}, {0, 0.5, 0.5, 1}}, 3, 0};
  CHECK(clip_against(kite, ClipPlane::right).count == 3);
  polygon.count = 20;
  CHECK_THROWS_AS(clip_against(polygon, ClipPlane::front), velum::ContractViolation);
}
