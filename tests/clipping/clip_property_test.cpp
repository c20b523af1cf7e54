#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "clipping/clip_polygon.hpp"
#include "clipping/clip_segment.hpp"
#include "clipping_data.hpp"
#include "exact_oracle.hpp"

using velum::clip_segment;
using velum::clip_triangle;
using velum::ClippedPolygon;
using velum::ClippedSegment;

namespace {

using Polygon = std::vector<glm::dvec4>;

ClippedPolygon clip(const Triangle& t) {
  return clip_triangle(t[0], t[1], t[2]);
}

bool contains(const ClippedPolygon& polygon, const glm::dvec4& vertex) {
  for (const glm::dvec4& v : polygon.span()) {
    if (same_bits(v, vertex)) return true;
  }
  return false;
}

/// Every vertex in the volume exactly, none twice in a row; the clipped clipped again, as it stands, is the
/// same.
bool is_clipped(const ClippedPolygon& polygon) {
  if (polygon.count == 0) return true;
  if (polygon.count < 3) return false;
  for (int i = 0; i < polygon.count; ++i) {
    const glm::dvec4& vertex = polygon.vertices[static_cast<unsigned>(i)];
    if (velum::outcode(vertex) != 0 || !(vertex.w > 0.0)) return false;
    const int next = (i + 1) % polygon.count;
    if (polygon.cut_by != 0 && vertex == polygon.vertices[static_cast<unsigned>(next)]) return false;
  }
  const std::vector<glm::dvec4> again = velum::clip_polygon(polygon.span());
  return std::equal(again.begin(), again.end(), polygon.span().begin(), polygon.span().end(), same_bits);
}

/// The vertices that the polygon has on the edge from a to b: those the segment has, bit for bit.
bool has_edge(const ClippedPolygon& polygon, const glm::dvec4& a, const glm::dvec4& b) {
  const ClippedSegment edge = clip_segment(a, b);
  if (!edge.visible || polygon.count == 0) return true;
  return contains(polygon, edge.a) && contains(polygon, edge.b);
}

/// Two triangles on the edge a b, each walked in every direction, and with each start.
bool edge_is_shared(Random& random) {
  const glm::dvec4 a = random_point(random), b = random_point(random);
  const glm::dvec4 c = random_point(random), d = random_point(random);
  bool good = true;
  for (const glm::dvec4& third : {c, d}) {
    for (const Triangle& t : {Triangle{a, b, third}, Triangle{b, a, third}, Triangle{third, a, b}}) {
      good = good && has_edge(clip(t), a, b);
    }
  }
  return good;
}

int count_broken(std::uint64_t seed, int cases, int& visible) {
  Random random{seed};
  int broken = 0;
  for (int i = 0; i < cases; ++i) {
    const Triangle t = random_triangle(random);
    const ClippedPolygon polygon = clip(t);
    visible += polygon.count > 0 ? 1 : 0;
    bool good = is_clipped(polygon);
    const int codes = velum::outcode(t[0]) | velum::outcode(t[1]) | velum::outcode(t[2]);
    // A plane that cuts is one that a vertex is outside of.
    good = good && (polygon.cut_by & ~codes) == 0;
    const bool accepted = codes == 0 && t[0].w > 0 && t[1].w > 0 && t[2].w > 0;
    if (accepted)
      good = good && std::equal(t.begin(), t.end(), polygon.span().begin(), polygon.span().end(), same_bits);
    if (!good || !edge_is_shared(random)) ++broken;
  }
  return broken;
}

// ---- accept and reject against exact integers ----

struct Verdicts {
  int wrong = 0, overlapping = 0, apart = 0, touching = 0;
};

Verdicts against_exact(std::uint64_t seed, int cases) {
  Random random{seed};
  Verdicts verdicts;
  const std::uint64_t range = 21;
  const auto coordinate = [&] { return static_cast<std::int64_t>(random.next() % range) - 10; };
  for (int i = 0; i < cases; ++i) {
    std::array<exact::Point, 3> points;
    Triangle t;
    for (unsigned k = 0; k < 3; ++k) {
      points[k] = {coordinate(), coordinate(), coordinate(), coordinate()};
      t[k] = {points[k][0], points[k][1], points[k][2], points[k][3]};
    }
    if (exact::dependent(points)) continue;
    const bool visible = clip(t).count > 0;
    switch (exact::meeting(points)) {
      case exact::Meeting::overlapping:
        ++verdicts.overlapping;
        if (!visible) ++verdicts.wrong;
        break;
      case exact::Meeting::apart:
        ++verdicts.apart;
        if (visible) ++verdicts.wrong;
        break;
      case exact::Meeting::touching:  // without area: rounding may decide either way
        ++verdicts.touching;
    }
  }
  return verdicts;
}

void check_verdicts(const Verdicts& verdicts, int cases) {
  CHECK(verdicts.wrong == 0);
  CHECK(verdicts.overlapping > cases / 20);
  CHECK(verdicts.apart > cases / 20);
  CHECK(verdicts.touching < cases / 20);
}

// ---- inside + outside = all, in the divided volume ----

/// n · (x, y, z) + offset ≥ 0.
struct HalfSpace {
  glm::dvec3 normal;
  double offset;
};

constexpr std::array<HalfSpace, 6> volume{
    {{{0, 0, 1}, 0}, {{0, 0, -1}, 1}, {{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, -1, 0}, 1}}};

using Flat = std::vector<glm::dvec3>;

/// The part of a polygon where sign · value ≥ 0: plain and independent of the library.
Flat part(const Flat& polygon, const HalfSpace& half_space, double sign) {
  Flat kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    const double dp = sign * (glm::dot(half_space.normal, p) + half_space.offset);
    const double dq = sign * (glm::dot(half_space.normal, q) + half_space.offset);
    if (dp >= 0) kept.push_back(p);
    if ((dp < 0) != (dq < 0)) kept.push_back(p + dp / (dp - dq) * (q - p));
  }
  return kept;
}

double area(const Flat& polygon) {
  glm::dvec3 twice{0.0};
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    twice += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  }
  return 0.5 * glm::length(twice);
}

/// |area - (inside + outside)|. The outside falls apart into what is outside plane 0, inside 0 and outside 1,
/// …
double area_defect(const Triangle& t) {
  const auto divided = [](std::span<const glm::dvec4> polygon) {
    Flat flat;
    for (const glm::dvec4& v : polygon) flat.push_back(glm::dvec3(v) / v.w);
    return flat;
  };
  Flat rest = divided(t);
  double sum = area(divided(clip(t).span()));
  for (const HalfSpace& half_space : volume) {
    sum += area(part(rest, half_space, -1.0));
    rest = part(rest, half_space, 1.0);
  }
  return std::abs(area(divided(t)) - sum);
}

/// Coordinates up to 4. A cut point is wrong by at most about 8 units of 2^-53 · 4 in each coordinate, moves
/// the area by at most that times the longest edge (√3·8); 7 polygons of at most 9 vertices: 63 · 2 · 14 · 32
/// · 2^-53.
constexpr double k_area_tolerance = 63.0 * 2.0 * 14.0 * 32.0 * 0x1p-53;

double worst_area_defect(std::uint64_t seed, int cases) {
  Random random{seed};
  double worst = 0.0;
  for (int i = 0; i < cases; ++i) {
    const double reach = random.uniform(0.5, 4.0);
    Triangle t;
    for (glm::dvec4& v : t) {
      v = {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach), 1.0};
    }
    worst = std::max(worst, area_defect(t));
  }
  return worst;
}

}  // namespace

TEST_CASE("clip_triangle: exact promises, seeded") {
  int visible = 0;
  CHECK(count_broken(21, 20000, visible) == 0);
  CHECK(visible > 20000 / 10);
}

TEST_CASE("clip_triangle: accept and reject agree with exact integers, seeded") {
  check_verdicts(against_exact(22, 20000), 20000);
}

TEST_CASE("clip_triangle: inside and outside add up to the whole, seeded") {
  CHECK(worst_area_defect(23, 20000) < k_area_tolerance);
}

TEST_CASE("[long] clip_triangle: exact promises, exact integers, areas") {
  int visible = 0;
  CHECK(count_broken(24, 1000000, visible) == 0);
  check_verdicts(against_exact(25, 1000000), 1000000);
  CHECK(worst_area_defect(26, 1000000) < k_area_tolerance);
}
