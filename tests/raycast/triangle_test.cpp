#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "random_rays.hpp"
#include "raycast/intersection/watertight.hpp"

using namespace velum;

namespace {

Aabb bounds_of(const Triangle& t) {
  Aabb box;
  for (const glm::dvec3& p : {t.a, t.b, t.c}) box.include(p);
  return box;
}

std::optional<TriangleHit> watertight(const Ray& ray, const Triangle& triangle) {
  return intersect_watertight(PreparedRay(ray, {}, bounds_of(triangle)), triangle);
}

/// t, β, γ of o + t·d = a + β(b - a) + γ(c - a), as a linear system.
Eigen::Vector3d solve(const Ray& ray, const Triangle& t) {
  const auto vector = [](const glm::dvec3& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
  Eigen::Matrix3d m;
  m.col(0) = -vector(ray.direction);
  m.col(1) = vector(t.b - t.a);
  m.col(2) = vector(t.c - t.a);
  return m.fullPivLu().solve(vector(ray.origin - t.a));
}

/// Turns x → y → z → x: every axis becomes the longest once.
glm::dvec3 turned(const glm::dvec3& v) {
  return {v.z, v.x, v.y};
}

}  // namespace

TEST_CASE("three triangle intersections agree with the linear system") {
  Random random{8};
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Triangle triangle{random_point(random), random_point(random), random_point(random)};
    const Ray ray = random_ray(random);
    const Eigen::Vector3d exact = solve(ray, triangle);
    const double least = std::min({exact[1], exact[2], 1.0 - exact[1] - exact[2]});
    if (std::fabs(least) < 1e-9) continue;
    for (const auto& hit : {intersect_by_plane(ray, triangle), intersect_moller_trumbore(ray, triangle),
                            watertight(ray, triangle)}) {
      REQUIRE(hit.has_value() == (least > 0.0));
      if (!hit) continue;
      ++hits;
      CHECK(hit->t == doctest::Approx(exact[0]).epsilon(1e-7));
      CHECK(hit->barycentric.y == doctest::Approx(exact[1]).epsilon(1e-6));
      CHECK(hit->barycentric.z == doctest::Approx(exact[2]).epsilon(1e-6));
    }
  }
  CHECK(hits > 500);
}

TEST_CASE("triangles that are too small for an epsilon are hit") {
  const double s = 1e-12;
  const Triangle triangle{{0, 0, 0}, {s, 0, 0}, {0, s, 0}};
  const Ray ray{{0.25 * s, 0.25 * s, 1.0}, {0, 0, -1}};
  CHECK(intersect_by_plane(ray, triangle));
  CHECK(intersect_moller_trumbore(ray, triangle));
  CHECK(watertight(ray, triangle));
}

TEST_CASE("a ray in a triangle's plane, a triangle without area, and NaN give nothing") {
  const Triangle flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const Ray& ray :
       {Ray{{-1, 0.25, 0}, {1, 0, 0}}, Ray{{-1, 0, 0}, {1, 0, 0}}, Ray{{0.2, 0.2, 1}, {0, 0, 0}},
        Ray{{0.2, nan, 1}, {0, 0, -1}}, Ray{{0.2, 0.2, 1}, {0, nan, -1}}, Ray{{0.2, 0.2, 1}, {0, 0, -inf}}}) {
    CHECK_FALSE(watertight(ray, flat));
    CHECK_FALSE(intersect_moller_trumbore(ray, flat));
    CHECK_FALSE(intersect_by_plane(ray, flat));
  }
  const Ray down{{0.25, 0.25, 1}, {0, 0, -1}};
  for (const Triangle& thin :
       {Triangle{{0, 0, 0}, {0, 0, 0}, {1, 1, 0}}, Triangle{{0, 0, 0}, {0.5, 0.5, 0}, {1, 1, 0}},
        Triangle{{0, 0, 0}, {nan, 0, 0}, {1, 1, 0}}}) {
    CHECK_FALSE(watertight(down, thin));
    CHECK_FALSE(intersect_moller_trumbore(down, thin));
    CHECK_FALSE(intersect_by_plane(down, thin));
  }
}

TEST_CASE("an edge that two triangles share is hit once, from both sides, along every axis") {
  // Two triangles over the unit square; the diagonal and its ends lie on whole numbers.
  glm::dvec3 a(0, 0, 0), b(4, 0, 0), c(4, 4, 0), d(0, 4, 0), from(0, 0, 8);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      for (const double along : {0.5, 1.0, 2.0, 3.75}) {
        const glm::dvec3 target = a + (c - a) * (along / 4.0);
        const Ray ray{target + from * side, from * -side};
        CHECK(watertight(ray, {a, b, c}).has_value() + watertight(ray, {a, c, d}).has_value() == 1);
      }
    }
    for (glm::dvec3* p : {&a, &b, &c, &d, &from}) *p = turned(*p);
  }
}

TEST_CASE("a corner that many triangles share is hit once") {
  const glm::dvec3 centre(0.0);
  const glm::dvec3 rim[6] = {{3, 0, 0}, {2, 3, 0}, {-1, 2, 0}, {-3, 0, 0}, {-2, -3, 0}, {1, -2, 0}};
  for (const glm::dvec3& origin : {glm::dvec3(0, 0, 5), glm::dvec3(1, -2, 3), glm::dvec3(-3, 1, -2)}) {
    int count = 0;
    for (int i = 0; i < 6; ++i) {
      count += watertight(Ray{origin, centre - origin}, {centre, rim[i], rim[(i + 1) % 6]}).has_value();
    }
    CHECK(count == 1);
  }
}

TEST_CASE("no random ray slips through the common edges of a fan that fills its view") {
  Random random{9};
  for (int i = 0; i < 2000; ++i) {
    // A tent over a square that is larger than all targets: any ray aimed at an edge meets one triangle.
    const glm::dvec3 tip(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.2, 0.2));
    const glm::dvec3 rim[4] = {{3, 3, 0}, {-3, 3, 0}, {-3, -3, 0}, {3, -3, 0}};
    const glm::dvec3 target = tip + (rim[i % 4] - tip) * random.uniform(0.0, 0.3);
    const glm::dvec3 origin(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 50.0);
    int count = 0;
    for (int k = 0; k < 4; ++k) {
      count += watertight(Ray{origin, target - origin}, {tip, rim[k], rim[(k + 1) % 4]}).has_value();
    }
    CHECK(count == 1);
  }
}

TEST_CASE("a hit lies inside the interval of the triangle's box, also where the ray grazes it") {
  Random random{10};
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    // Corners on whole multiples, so that rays in the plane are so nearly: t is then anybody's guess.
    const auto corner = [&] { return glm::dvec3(random.below(9), random.below(9), random.below(9)) * 0.25; };
    const glm::dvec3 a = corner(), b = corner(), c = corner();
    const glm::dvec3 inside = a + (b - a) * 0.3 + (c - a) * 0.3;
    const glm::dvec3 along = (b - a) * random.uniform(-1, 1) + (c - a) * random.uniform(-1, 1);
    const Aabb box = bounds_of({a, b, c});
    const PreparedRay prepared({inside - along * 2.0, along}, {}, box);
    const auto hit = intersect_watertight(prepared, {a, b, c});
    if (!hit) continue;
    ++hits;
    CHECK(prepared.through(box.lower, box.upper).contains(hit->t));
  }
  CHECK(hits > 1000);
}
