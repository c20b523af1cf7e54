#include "projection/facing.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "random.hpp"

namespace {

using velum::Facing;

struct Triangle {
  glm::dvec3 a, b, c;
};

Triangle random_triangle(Random& random) {
  const auto point = [&] {
    const double x = random.uniform(-2, 2), y = random.uniform(-2, 2), z = random.uniform(-2, 2);
    return glm::dvec3(x, y, z);
  };
  const glm::dvec3 a = point(), b = point(), c = point();
  return {a, b, c};
}

double determinant_of(const glm::dmat4& clip_from_world, const Triangle& t) {
  return velum::homogeneous_determinant(clip_from_world * glm::dvec4(t.a, 1.0),
                                        clip_from_world * glm::dvec4(t.b, 1.0),
                                        clip_from_world * glm::dvec4(t.c, 1.0));
}

/// The viewer at (0, 0, distance) looking down -z: rows x, y, w of any perspective composite up to a factor >
/// 0.
glm::dmat4 perspective_from(double distance) {
  glm::dmat4 m(0.0);
  m[0][0] = 1.0;
  m[1][1] = 1.0;
  m[2][3] = -1.0;
  m[3][3] = distance;
  return m;
}

}  // namespace

TEST_CASE("counter-clockwise in the picture is front, edge-on too; a mirrored instance flips") {
  const glm::dvec4 a(0, 0, 0, 1), b(1, 0, 0, 1), c(0, 1, 0, 1);
  CHECK(velum::homogeneous_determinant(a, b, c) == 1.0);
  CHECK(velum::homogeneous_determinant(a, c, b) == -1.0);
  CHECK(velum::facing_of(1.0, false) == Facing::front);
  CHECK(velum::facing_of(-1.0, false) == Facing::back);
  CHECK(velum::facing_of(1.0, true) == Facing::back);
  CHECK(velum::facing_of(-1.0, true) == Facing::front);
  CHECK(velum::facing_of(0.0, false) == Facing::front);
  CHECK(velum::facing_of(-0.0, true) == Facing::front);
  glm::dmat4 mirror(1.0);
  CHECK_FALSE(velum::is_mirroring(mirror));
  mirror[1][1] = -3.0;
  CHECK(velum::is_mirroring(mirror));
}

TEST_CASE("line of sight, half-space, π·e and the homogeneous determinant agree: perspective") {
  Random random{1};
  for (int i = 0; i < 2000; ++i) {
    const Triangle t = random_triangle(random);
    const double distance = random.uniform(-1, 5);  // triangles behind and around the viewer as well
    const glm::dvec3 cop(0, 0, distance);
    const velum::Plane plane = velum::Plane::through(t.a, t.b, t.c);
    const double side = velum::side_of_viewer(plane, {cop, 1.0});
    if (std::abs(side) < 1e-9) continue;
    CHECK((velum::half_space_test(plane, cop) > 0) == (side > 0));
    for (const glm::dvec3& p : {t.a, t.b, t.c}) {
      CHECK((velum::line_of_sight_test(plane, p, {cop, 1.0}) < 0) == (side > 0));
    }
    CHECK((determinant_of(perspective_from(distance), t) > 0) == (side > 0));
  }
}

TEST_CASE("line of sight, π·e and the homogeneous determinant agree: oblique") {
  Random random{2};
  for (int i = 0; i < 2000; ++i) {
    const Triangle t = random_triangle(random);
    glm::dmat4 m(1.0);  // x' = x + sx·z, y' = y + sy·z; the DOP is (sx, sy, -1)
    m[2][0] = random.uniform(-1, 1);
    m[2][1] = random.uniform(-1, 1);
    const glm::dvec4 eye(-m[2][0], -m[2][1], 1.0, 0.0);
    const velum::Plane plane = velum::Plane::through(t.a, t.b, t.c);
    const double side = velum::side_of_viewer(plane, eye);
    if (std::abs(side) < 1e-9) continue;
    CHECK((velum::line_of_sight_test(plane, t.a, eye) < 0) == (side > 0));
    CHECK((determinant_of(m, t) > 0) == (side > 0));
  }
}
