#include "spatial/bounding_volume.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "random.hpp"
#include "spatial/convex_hull.hpp"
#include "spatial/enclosing_ellipsoid.hpp"

using namespace velum;

namespace {

using Points = std::vector<glm::vec3>;
constexpr double turn = 3.14159265358979;

glm::dvec3 on_ball(Random& random) {
  for (;;) {
    const glm::dvec3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double length = glm::length(p);
    if (length > 0.1 && length < 1.0) return p / length;
  }
}

/// Points on an ellipsoid, turned so that its axes are not those of space.
Points tilted(int count, const glm::dvec3& axes) {
  Random random{61};
  const glm::dmat3 turned(glm::dvec3(2, 1, 2) / 3.0, glm::dvec3(-2, 2, 1) / 3.0, glm::dvec3(-1, -2, 2) / 3.0);
  Points points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(turned * (axes * on_ball(random)) + glm::dvec3(5, 6, 7));
  return points;
}

bool is_built(VolumeKind kind) {
  return kind != VolumeKind::convex_hull || has_convex_hull();
}

/// How far out a point is, in units of the volume's size; at most 0 for one inside.
double outside(const BoundingVolume& volume, const glm::vec3& point, double size) {
  const glm::dvec3 p(point);
  if (volume.is_round()) return glm::length(volume.ball_from_space * (p - volume.centre)) - 1.0;
  double most = -1.0;
  for (const Plane& plane : volume.planes) most = std::max(most, plane.signed_value(p) / size);
  return most;
}

double area(VolumeKind kind, const Points& points) {
  return bounding_volume(kind, points).area;
}

}  // namespace

TEST_CASE("every bounding volume holds its points, of few and flat ones, too") {
  const std::vector<Points> sets = {
      {{1, 2, 3}},
      {{1, 2, 3}, {1, 2, 3}},
      {{0, 0, 0}, {1e4f, 1, 0}},
      {{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {3, 3, 5}},
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      tilted(500, {3, 1, 0.2}),
      tilted(40, {1e-3, 1e-3, 1e3}),
  };
  for (const VolumeName& name : volume_names()) {
    if (!is_built(name.kind)) continue;
    CAPTURE(std::string(name.name));
    for (const Points& points : sets) {
      CAPTURE(points.size());
      const BoundingVolume volume = bounding_volume(name.kind, points);
      CHECK(volume.area >= 0.0);
      double most = -1.0;
      for (const glm::vec3& p : points) most = std::max(most, outside(volume, p, 1e3));
      CHECK(most <= 0x1.0p-40);
    }
  }
}

TEST_CASE("areas of bounding volumes: a cube's, a ball's, an octahedron's and spheroids'") {
  const Points cube = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0},
                       {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}};
  for (const VolumeKind kind : {VolumeKind::aabb, VolumeKind::dop14, VolumeKind::dop18, VolumeKind::dop26}) {
    CHECK(area(kind, cube) == doctest::Approx(24.0));
  }
  if (has_convex_hull()) CHECK(area(VolumeKind::convex_hull, cube) == doctest::Approx(24.0));
  CHECK(area(VolumeKind::sphere, cube) == doctest::Approx(4.0 * turn * 3.0).epsilon(0.01));
  CHECK(area(VolumeKind::ellipsoid, cube) == doctest::Approx(4.0 * turn * 3.0).epsilon(0.01));
  const Points octahedron = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  CHECK(area(VolumeKind::dop14, octahedron) == doctest::Approx(4.0 * std::sqrt(3.0)));
  if (has_convex_hull())
    CHECK(area(VolumeKind::convex_hull, octahedron) == doctest::Approx(4.0 * std::sqrt(3.0)));
  // Long: 2πa²(1 + c/(a·e)·asin e) with e² = 1 - a²/c². Flat discs have two sides.
  const double e = std::sqrt(1.0 - 1.0 / 9.0);
  const double spheroid = 2.0 * turn * (1.0 + 3.0 / e * std::asin(e));
  CHECK(ellipsoid_area(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 1.0 / 3.0)) ==
        doctest::Approx(spheroid).epsilon(1e-3));
  CHECK(ellipsoid_area(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 1e4)) == doctest::Approx(2.0 * turn).epsilon(1e-2));
}

TEST_CASE("tighter volumes have less surface") {
  const Points points = tilted(3000, {3, 1, 0.5});
  const double aabb = area(VolumeKind::aabb, points), all = area(VolumeKind::dop26, points);
  CHECK(all < area(VolumeKind::dop14, points));
  CHECK(all < area(VolumeKind::dop18, points));
  CHECK(area(VolumeKind::dop14, points) < aabb);
  CHECK(area(VolumeKind::dop18, points) < aabb);
  const double ellipsoid = area(VolumeKind::ellipsoid, points);
  CHECK(ellipsoid < 0.5 * area(VolumeKind::sphere, points));
  CHECK(ellipsoid < all);
  if (!has_convex_hull()) return;
  CHECK(area(VolumeKind::convex_hull, points) < all);
  CHECK(area(VolumeKind::convex_hull, points) < ellipsoid);
}

TEST_CASE("the ball and the ellipsoid are near the smallest") {
  const Points ball = tilted(2000, {2, 2, 2});
  CHECK(enclosing_ball(ball).radius < 2.0 * 1.01);
  Points corner = ball;  // one side crowded: its centre of gravity is no centre of the ball
  for (int i = 0; i < 5000; ++i) corner.push_back(ball[0]);
  CHECK(enclosing_ball(corner).radius < 2.0 * 1.01);
  // The volume of a unit ball over det is that of the ellipsoid.
  const EnclosingEllipsoid found = enclosing_ellipsoid(tilted(2000, {3, 1, 0.5}));
  const double product = 1.0 / std::fabs(glm::determinant(found.ball_from_space));
  CHECK(product < 1.5 * 1.03);
  CHECK(product > 1.5 * 0.97);
}
