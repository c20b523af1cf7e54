#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "random_rays.hpp"
#include "raycast/intersection/plane_intersection.hpp"
#include "raycast/intersection/polygon_intersection.hpp"
#include "raycast/intersection/triangle_intersection.hpp"

using namespace velum;

namespace {

/// A star-shaped, mostly concave polygon in a random plane: the triangles from its centre tile it.
struct Star {
  glm::dvec3 centre;
  std::vector<glm::dvec3> corners;

  Star(Random& random, int count, double least) : centre(random_point(random)) {
    const glm::dvec3 u = random_point(random);
    const glm::dvec3 v = glm::cross(u, random_point(random));
    for (int i = 0; i < count; ++i) {
      const double angle = 6.283185307179586 * i / count;
      const double radius = random.uniform(least, 1.0);
      corners.push_back(centre + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  }
  bool is_hit_by(const Ray& ray) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (intersect_moller_trumbore(ray, {centre, corners[i], corners[(i + 1) % corners.size()]}))
        return true;
    }
    return false;
  }
};

}  // namespace

TEST_CASE("a plane is hit where its equation is 0, and not by rays along it") {
  Random random{5};
  for (int i = 0; i < 500; ++i) {
    const Plane plane = Plane::through(random_point(random), random_point(random), random_point(random));
    const Ray ray = random_ray(random);
    const auto hit = intersect(ray, plane);
    REQUIRE(hit);
    CHECK(std::fabs(plane.signed_value(ray.at(hit->t))) < 1e-9);
  }
  const Plane ground{{0, 1, 0}, 0.0};
  CHECK_FALSE(intersect(Ray{{0, 1, 0}, {1, 0, 0}}, ground));
  CHECK_FALSE(intersect(Ray{{0, 0, 0}, {1, 0, 0}}, ground));
}

TEST_CASE("a rectangle is its plane within its sides") {
  Random random{6};
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Rectangle r{random_point(random), random_point(random), random_point(random)};
    const std::vector<glm::dvec3> corners{r.corner, r.corner + r.u, r.corner + r.u + r.v, r.corner + r.v};
    const Ray ray = random_ray(random);
    const auto hit = intersect(ray, r);
    const bool expected = intersect_moller_trumbore(ray, {corners[0], corners[1], corners[2]}) ||
                          intersect_moller_trumbore(ray, {corners[0], corners[2], corners[3]});
    CHECK(hit.has_value() == expected);
    hits += expected;
  }
  CHECK(hits > 100);
}

TEST_CASE("convex and concave polygons are hit where one of their triangles is") {
  Random random{7};
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const bool convex = i % 2 == 0;
    const Star star(random, convex ? 6 : 9, convex ? 1.0 : 0.2);
    const glm::dvec3 target = star.centre + (random_point(random) * 0.7);
    const glm::dvec3 origin = random_point(random, 3.0);
    const Ray ray{origin, target - origin};
    const bool expected = star.is_hit_by(ray);
    CHECK(intersect_polygon(ray, star.corners).has_value() == expected);
    if (convex) CHECK(intersect_convex_polygon(ray, star.corners).has_value() == expected);
    hits += expected;
  }
  CHECK(hits > 300);
}

TEST_CASE("half-lines through corners of a polygon count once") {
  const std::vector<glm::dvec3> diamond{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (const double x : {-0.75, 0.0, 0.5}) CHECK(intersect_polygon(Ray{{x, 0, 3}, {0, 0, -1}}, diamond));
  for (const double x : {-1.5, 1.5}) CHECK_FALSE(intersect_polygon(Ray{{x, 0, 3}, {0, 0, -1}}, diamond));
  CHECK_FALSE(intersect_polygon(Ray{{0, 0, 3}, {0, 0, -1}}, std::span(diamond).first(2)));
}
