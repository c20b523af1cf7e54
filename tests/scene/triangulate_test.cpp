#include "scene/triangulate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "random.hpp"
#include "scene/orientation.hpp"

using velum::Triangulator;

namespace {

using Polygon2 = std::vector<glm::dvec2>;

double area(const Polygon2& p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const glm::dvec2 &a = p[i], &b = p[(i + 1) % p.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum / 2;
}

// Even-odd rule.
bool is_inside(const Polygon2& p, const glm::dvec2& q) {
  bool inside = false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const glm::dvec2 &a = p[i], &b = p[(i + 1) % p.size()];
    if ((a.y > q.y) != (b.y > q.y) && q.x < a.x + (q.y - a.y) * (b.x - a.x) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

std::vector<glm::vec3> placed(const Polygon2& p, const glm::dvec3& u, const glm::dvec3& v,
                              const glm::dvec3& origin) {
  std::vector<glm::vec3> corners;
  for (const glm::dvec2& q : p) corners.emplace_back(glm::vec3(origin + u * q.x + v * q.y));
  return corners;
}

std::vector<glm::uvec3> triangulated(const std::vector<glm::vec3>& corners) {
  Triangulator triangulator;
  std::vector<glm::uvec3> triangles;
  REQUIRE(triangulator.triangulate(corners, triangles));
  return triangles;
}

// n - 2 triangles, none turned over, none outside, together the polygon's area: so they cover it once.
void check_cover(const Polygon2& p, const std::vector<glm::uvec3>& triangles) {
  REQUIRE(triangles.size() == p.size() - 2);
  const double whole = area(p);
  const double sign = whole < 0 ? -1.0 : 1.0;
  double sum = 0.0;
  for (const glm::uvec3& t : triangles) {
    const double one = area({p[t.x], p[t.y], p[t.z]}) * sign;
    CHECK(one >= -1e-6 * std::abs(whole));
    sum += one;
    const glm::dvec2 centroid = (p[t.x] + p[t.y] + p[t.z]) / 3.0;
    if (one > 1e-5 * std::abs(whole)) CHECK(is_inside(p, centroid));
  }
  CHECK(sum == doctest::Approx(std::abs(whole)).epsilon(1e-6));
}

Polygon2 star(Random& random, std::size_t n) {
  Polygon2 p;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        2 * 3.141592653589793 * (static_cast<double>(i) + 0.8 * random.uniform()) / static_cast<double>(n);
    const double radius = random.uniform(0.2, 1.0);
    p.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return p;
}

// Teeth of random length on a bar, with corners on one line between them.
Polygon2 comb(Random& random, std::size_t teeth) {
  Polygon2 p{{0.0, 0.0}, {static_cast<double>(2 * teeth), 0.0}};
  for (std::size_t i = teeth; i-- > 0;) {
    const double x = static_cast<double>(2 * i), height = std::floor(random.uniform(2.0, 9.0));
    p.insert(p.end(), {{x + 2, 1.0}, {x + 1.5, 1.0}, {x + 1, height}, {x + 0.5, height}, {x, 1.0}});
  }
  return p;
}

Polygon2 spiral(std::size_t turns) {
  Polygon2 outer, inner;
  for (std::size_t i = 0; i < 16 * turns; ++i) {
    const double angle = 2 * 3.141592653589793 * static_cast<double>(i) / 16, radius = 3.0 + angle;
    outer.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    inner.emplace_back((radius - 2.0) * std::cos(angle), (radius - 2.0) * std::sin(angle));
  }
  Polygon2 p(outer);
  p.insert(p.end(), inner.rbegin(), inner.rend());
  return p;
}

glm::dvec3 random_direction(Random& random) {
  glm::dvec3 v;
  do {
    v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  } while (glm::dot(v, v) > 1.0 || glm::dot(v, v) < 0.01);
  return glm::normalize(v);
}

void check_in_space(const Polygon2& p, Random& random) {
  const glm::dvec3 u = random_direction(random), v = glm::normalize(glm::cross(u, random_direction(random)));
  const glm::dvec3 origin{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
  check_cover(p, triangulated(placed(p, u, v, origin)));
  Polygon2 reversed(p.rbegin(), p.rend());
  check_cover(reversed, triangulated(placed(reversed, u, v, origin)));
}

const glm::dvec3 x_axis(1, 0, 0), y_axis(0, 1, 0), zero(0);

}  // namespace

TEST_CASE("orientation is exact") {
  const glm::vec2 a(0.5f, 0.5f), b(12.0f, 12.0f);
  CHECK(velum::orientation(a, b, {24.0f, 24.0f}) == 0);
  const float above = std::nextafter(24.0f, 25.0f);
  CHECK(velum::orientation(a, b, {24.0f, above}) == 1);
  CHECK(velum::orientation(a, b, {above, 24.0f}) == -1);
  // Differences that double cannot hold: 2^100 hides 2^-40, the sign hangs on it.
  const float huge = 0x1p100f, tiny = 0x1p-40f;
  CHECK(velum::orientation({0, 0}, {huge, huge}, {tiny, 2 * tiny}) == 1);
  CHECK(velum::orientation({-huge, -huge}, {huge, huge}, {tiny, 0}) == -1);
  CHECK(velum::orientation({-huge, -huge}, {huge, huge}, {tiny, tiny}) == 0);
}

TEST_CASE("small polygons: none, triangle, quads") {
  CHECK(triangulated({}).empty());
  CHECK(triangulated({{0, 0, 0}, {1, 0, 0}}).empty());
  CHECK(triangulated({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == std::vector<glm::uvec3>{{0, 1, 2}});
  CHECK(triangulated({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) ==
        std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}});
  // An arrowhead, its notch at each corner in turn.
  const Polygon2 arrow{{0, 0}, {2, -1}, {0, 3}, {-2, -1}};
  for (std::ptrdiff_t shift = 0; shift < 4; ++shift) {
    Polygon2 p(arrow);
    std::rotate(p.begin(), p.begin() + shift, p.end());
    check_cover(p, triangulated(placed(p, x_axis, y_axis, zero)));
  }
}

TEST_CASE("concave polygons in random planes are covered exactly") {
  Random random{1};
  for (int i = 0; i < 60; ++i) {
    check_in_space(star(random, 4 + static_cast<std::size_t>(i)), random);
    check_in_space(comb(random, 1 + static_cast<std::size_t>(i) / 3), random);
  }
  check_in_space(spiral(4), random);
}

TEST_CASE("corners on one line and corners twice in the same place") {
  const Polygon2 square{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  check_cover(square, triangulated(placed(square, x_axis, y_axis, zero)));
  const Polygon2 ell{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}};
  check_cover(ell, triangulated(placed(ell, x_axis, y_axis, zero)));
}

TEST_CASE("a hole joined to the outline by a double edge stays a hole") {
  for (int n = 3; n < 40; ++n) {
    Polygon2 p;
    for (int i = 0; i <= n; ++i) {
      const double angle = 2 * 3.141592653589793 * (i % n) / n;
      p.emplace_back(2 * std::cos(angle), 2 * std::sin(angle));
    }
    for (int i = n; i >= 0; --i) {
      const double angle = 2 * 3.141592653589793 * (i % n) / n;
      p.emplace_back(std::cos(angle), std::sin(angle));
    }
    check_cover(p, triangulated(placed(p, x_axis, y_axis, zero)));
  }
}

TEST_CASE("degenerate polygons give n - 2 triangles all the same") {
  const float nan = std::numeric_limits<float>::quiet_NaN(),
              infinity = std::numeric_limits<float>::infinity();
  CHECK(triangulated(std::vector<glm::vec3>(7, glm::vec3(1.0f))).size() == 5);
  CHECK(triangulated({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).size() == 2);
  CHECK(triangulated({{0, 0, 0}, {nan, 0, 0}, {1, 1, 0}, {0, 1, 0}}).size() == 2);
  CHECK(triangulated({{0, 0, 0}, {1, 0, infinity}, {1, 1, 0}, {0, 1, 0}, {0, 0, 2}}).size() == 3);
  CHECK(triangulated({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() == 2);
  Random random{2};
  for (std::size_t n = 4; n < 80; ++n) {
    std::vector<glm::vec3> corners;
    for (std::size_t i = 0; i < n; ++i) {
      const auto grid = [&] { return static_cast<float>(random.next() % 5); };
      corners.emplace_back(grid(), grid(), n % 3 == 0 ? grid() : 0.0f);
    }
    const std::vector<glm::uvec3> triangles = triangulated(corners);
    CHECK(triangles.size() == n - 2);
    for (const glm::uvec3& t : triangles) CHECK(std::max({t.x, t.y, t.z}) < n);
  }
}

TEST_CASE("only concave polygons are limited") {
  Random random{3};
  Triangulator triangulator;
  std::vector<glm::uvec3> triangles;
  const Polygon2 large = star(random, Triangulator::most_concave_corners + 1);
  CHECK_FALSE(triangulator.triangulate(placed(large, x_axis, y_axis, zero), triangles));
  CHECK(triangles.empty());
  std::vector<glm::vec3> stairs{{0, 20000, 0}};  // convex: a parabola
  for (int i = 0; i < 4000; ++i) stairs.emplace_back(static_cast<float>(i), static_cast<float>(i * i), 0.0f);
  for (int i = 0; i < 8000; ++i) stairs.emplace_back(3999.0f, 15992001.0f + static_cast<float>(i), 0.0f);
  stairs[0] = {0, 16000001, 0};
  CHECK(triangulator.triangulate(stairs, triangles));
  CHECK(triangles.size() == stairs.size() - 2);
}

TEST_CASE("concave polygons beyond the work allowed become fans, the same ones every time") {
  Random random{5};
  std::vector<std::vector<glm::vec3>> polygons;  // crossing themselves: the dearest kind
  for (int i = 0; i < 20; ++i) {
    std::vector<glm::vec3> corners(200);
    for (glm::vec3& corner : corners) {
      corner = {static_cast<float>(random.uniform()), static_cast<float>(random.uniform()), 0.0f};
    }
    polygons.push_back(corners);
  }
  const auto fans = [&polygons](std::uint64_t steps) {
    Triangulator triangulator(steps);
    std::vector<glm::uvec3> triangles;
    for (const std::vector<glm::vec3>& corners : polygons) {
      CHECK(triangulator.triangulate(corners, triangles));
    }
    CHECK(triangles.size() == polygons.size() * 198);
    return triangulator.fan_count();
  };
  CHECK(fans(Triangulator::steps_for(0)) == 0);
  CHECK(fans(0) == 20);
  const std::size_t some = fans(200000);
  CHECK(some > 0);
  CHECK(some < 20);
  CHECK(fans(200000) == some);
  // Convex ones cost nothing, and are right when nothing is left.
  Triangulator spent(0);
  std::vector<glm::uvec3> triangles;
  spent.triangulate(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, triangles);
  CHECK(spent.fan_count() == 0);
}

TEST_CASE("[long] large concave polygons") {
  Random random{4};
  check_in_space(star(random, Triangulator::most_concave_corners), random);
  check_in_space(comb(random, 1600), random);
  check_in_space(spiral(200), random);
  for (int i = 0; i < 2000; ++i) check_in_space(star(random, 4 + random.next() % 30), random);
}
