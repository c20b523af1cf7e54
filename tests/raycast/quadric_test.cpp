#include <doctest/doctest.h>

#include <cmath>
#include <glm/matrix.hpp>

#include "random_rays.hpp"
#include "raycast/intersection/cylinder_intersection.hpp"
#include "raycast/intersection/ellipsoid_intersection.hpp"
#include "raycast/intersection/sphere_intersection.hpp"

using namespace velum;

namespace {

/// Whether a line comes closer to a point than `distance`, by the cross product.
double distance_to_line(const glm::dvec3& p, const Ray& ray) {
  return glm::length(glm::cross(p - ray.origin, ray.direction)) / glm::length(ray.direction);
}

/// α along the axis and the distance from it.
struct InCylinder {
  double alpha, distance;
};
InCylinder in_cylinder(const glm::dvec3& p, const Cylinder& c) {
  const glm::dvec3 axis = c.second - c.first;
  return {glm::dot(p - c.first, axis) / glm::dot(axis, axis),
          glm::length(glm::cross(p - c.first, axis)) / glm::length(axis)};
}
bool is_inside(const glm::dvec3& p, const Cylinder& c, double slack) {
  const InCylinder place = in_cylinder(p, c);
  return place.alpha >= -slack && place.alpha <= 1.0 + slack && place.distance <= c.radius + slack;
}

Cylinder random_cylinder(Random& random) {
  return {random_point(random), random_point(random), random.uniform(0.05, 0.8), true};
}

}  // namespace

TEST_CASE("a sphere is hit where the distance to its centre is the radius") {
  Random random{2};
  int hit = 0;
  for (int i = 0; i < 2000; ++i) {
    const Sphere sphere{random_point(random), random.uniform(0.1, 1.0)};
    const Ray ray = random_ray(random);
    const SurfaceHits hits = intersect(ray, sphere);
    const double closest = distance_to_line(sphere.centre, ray);
    if (closest < sphere.radius - 1e-9) REQUIRE(hits.count == 2);
    if (closest > sphere.radius + 1e-9) REQUIRE(hits.count == 0);
    for (int k = 0; k < hits.count; ++k) {
      const SurfaceHit& h = hits.hits[static_cast<std::size_t>(k)];
      CHECK(std::fabs(glm::length(ray.at(h.t) - sphere.centre) - sphere.radius) < 1e-12);
      CHECK(glm::length(h.normal - (ray.at(h.t) - sphere.centre) / sphere.radius) < 1e-9);
    }
    if (hits.count == 2) CHECK(hits.hits[0].t < hits.hits[1].t);
    hit += hits.count;
  }
  CHECK(hit > 500);
}

TEST_CASE("a sphere far away, and one under the ray's origin, lose no digits") {
  const Sphere far{{0.0, 0.0, -1e8}, 1.0};
  const SurfaceHits hits = intersect(Ray{{0.5, 0.0, 0.0}, {0.0, 0.0, -1.0}}, far);
  REQUIRE(hits.count == 2);
  CHECK(hits.hits[0].t == doctest::Approx(1e8 - std::sqrt(0.75)).epsilon(1e-15));
  CHECK(hits.hits[1].t - hits.hits[0].t == doctest::Approx(2.0 * std::sqrt(0.75)).epsilon(1e-7));

  const double gap = 1e-13;  // the origin just above the surface of a large sphere: the near root is tiny
  const SurfaceHits near = intersect(Ray{{0.0, 0.0, 1e3}, {0.0, 0.0, -1.0}}, Sphere{{0, 0, -gap}, 1e3});
  REQUIRE(near.count == 2);
  CHECK(near.hits[0].t == doctest::Approx(gap).epsilon(0.2));
}

TEST_CASE("a sphere without radius and a ray without direction give nothing") {
  CHECK(intersect(Ray{{0, 0, 5}, {0, 0, -1}}, Sphere{{0, 0, 0}, 0.0}).count == 0);
  CHECK(intersect(Ray{{0, 0, 0}, {0, 0, 0}}, Sphere{}).count == 0);
  CHECK(intersect(Ray{{0, 1, 0}, {1, 0, 0}}, Sphere{}).count == 1);  // touches at its origin
  CHECK_FALSE(intersect(Ray{{0, 0, 5}, {0, 0, 1}}, Sphere{}).first_in({0.0, 1e9}));
}

TEST_CASE("an ellipsoid is hit where its implicit equation is 0") {
  Random random{3};
  int hit = 0;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 half(random.uniform(0.1, 1.0), random.uniform(0.1, 1.0), random.uniform(0.1, 1.0));
    const glm::dvec3 centre = random_point(random);
    glm::dmat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = half[axis];
    matrix[3] = glm::dvec4(centre, 1.0);
    const Ray ray = random_ray(random);
    // x²/a² + y²/b² + z²/c² = 1 as a quadratic in t.
    const glm::dvec3 o = (ray.origin - centre) / half, d = ray.direction / half;
    const double discriminant = std::pow(glm::dot(o, d), 2) - glm::dot(d, d) * (glm::dot(o, o) - 1.0);
    const SurfaceHits hits = intersect(ray, Ellipsoid{matrix});
    if (std::fabs(discriminant) < 1e-9) continue;
    REQUIRE(hits.count == (discriminant > 0.0 ? 2 : 0));
    if (hits.count == 0) continue;
    ++hit;
    CHECK(hits.hits[0].t == doctest::Approx((-glm::dot(o, d) - std::sqrt(discriminant)) / glm::dot(d, d)));
    const glm::dvec3 gradient = (ray.at(hits.hits[0].t) - centre) / (half * half);
    CHECK(glm::length(hits.hits[0].normal - glm::normalize(gradient)) < 1e-9);
  }
  CHECK(hit > 100);
}

TEST_CASE("an ellipsoid under a singular matrix gives nothing") {
  glm::dmat4 flat(1.0);
  flat[2][2] = 0.0;
  CHECK(intersect(Ray{{0, 0, 5}, {0, 0, -1}}, Ellipsoid{flat}).count == 0);
}

TEST_CASE("a capped cylinder is entered and left where inside and outside meet") {
  Random random{4};
  int caps = 0, sides = 0;
  for (int i = 0; i < 3000; ++i) {
    const Cylinder cylinder = random_cylinder(random);
    const Ray ray = random_ray(random);
    const SurfaceHits hits = intersect(ray, cylinder);
    if (hits.count == 0) {
      for (int k = 0; k < 20; ++k) CHECK_FALSE(is_inside(ray.at(random.uniform(-3, 3)), cylinder, -1e-9));
      continue;
    }
    REQUIRE(hits.count == 2);
    const double t0 = hits.hits[0].t, t1 = hits.hits[1].t;
    CHECK(is_inside(ray.at(0.5 * (t0 + t1)), cylinder, 1e-9));
    CHECK_FALSE(is_inside(ray.at(t0 - 1e-6), cylinder, -1e-9));
    CHECK_FALSE(is_inside(ray.at(t1 + 1e-6), cylinder, -1e-9));
    const InCylinder place = in_cylinder(ray.at(t0), cylinder);
    const bool on_side = std::fabs(place.distance - cylinder.radius) < 1e-9;
    CHECK((on_side || std::fabs(place.alpha) < 1e-9 || std::fabs(place.alpha - 1.0) < 1e-9));
    CHECK(glm::dot(hits.hits[0].normal, ray.direction) <= 1e-9);
    CHECK(glm::dot(hits.hits[1].normal, ray.direction) >= -1e-9);
    ++(on_side ? sides : caps);
  }
  CHECK(caps > 50);
  CHECK(sides > 50);
}

TEST_CASE("a tube without caps is open at its ends") {
  const Cylinder tube{{0, 0, 0}, {0, 0, 4}, 1.0, false};
  CHECK(intersect(Ray{{0, 0, 9}, {0, 0, -1}}, tube).count == 0);  // along the axis, through
  const SurfaceHits inside =
      intersect(Ray{{0, 0, 5}, {0.25, 0, -1}}, tube);  // in at the end, out at the side
  REQUIRE(inside.count == 1);
  CHECK(inside.hits[0].t == doctest::Approx(4.0));
  CHECK(inside.hits[0].normal.x == doctest::Approx(1.0));
  // The lecture's Δp = p1 - p2 would put the tube on the other side of p1.
  CHECK(intersect(Ray{{5, 0, 2}, {-1, 0, 0}}, tube).count == 2);
  CHECK(intersect(Ray{{5, 0, -2}, {-1, 0, 0}}, tube).count == 0);
  Cylinder closed = tube;
  closed.has_caps = true;
  CHECK(intersect(Ray{{0, 0, 9}, {0, 0, -1}}, closed).count == 2);
  CHECK(intersect(Ray{{0, 0, 9}, {0, 0, -1}}, Cylinder{{0, 0, 0}, {0, 0, 0}, 1.0}).count == 0);
}
