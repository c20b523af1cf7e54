#include <doctest/doctest.h>

#include <limits>

#include "random_rays.hpp"
#include "raycast/intersection/box_intersection.hpp"

using namespace velum;

namespace {

const Aabb unit_box{glm::dvec3(-1.0), glm::dvec3(1.0)};

void check_both(const Ray& ray, const Aabb& box, const Interval& expected) {
  for (const Interval& found : {box_interval_by_cases(ray, box), box_interval_branchless(ray, box)}) {
    REQUIRE(found.is_empty() == expected.is_empty());
    if (expected.is_empty()) continue;
    CHECK(found.lower == doctest::Approx(expected.lower));
    CHECK(found.upper == doctest::Approx(expected.upper));
  }
}

bool is_inside(const glm::dvec3& p, const Aabb& box, double slack) {
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] < box.lower[axis] - slack || p[axis] > box.upper[axis] + slack) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("intervals intersect as the lecture has it") {
  CHECK(intersect(Interval{0, 2}, Interval{1, 3}).lower == 1);
  CHECK(intersect(Interval{0, 2}, Interval{1, 3}).upper == 2);
  CHECK(intersect(Interval{0, 1}, Interval{2, 3}).is_empty());
  CHECK_FALSE(intersect(Interval{0, 1}, Interval{1, 2}).is_empty());
  CHECK(Interval::empty().is_empty());
}

TEST_CASE("a ray meets a box head-on, along a side, and beside it") {
  check_both({{0, 0, 5}, {0, 0, -1}}, unit_box, {4, 6});
  check_both({{0, 0, 0}, {0, 2, 0}}, unit_box, {-0.5, 0.5});
  check_both({{1, 0, 5}, {0, 0, -1}}, unit_box, {4, 6});  // in the boundary plane: v = 0 on x
  check_both({{-1, 1, 5}, {-0.0, 0, -1}}, unit_box, {4, 6});
  check_both({{1.5, 0, 5}, {0, 0, -1}}, unit_box, Interval::empty());
  check_both({{0, 0, 5}, {0, 0, 0}}, unit_box, Interval::empty());
  check_both({{0, 0, 5}, {0, 0, -1}}, Aabb{}, Interval::empty());
  check_both({{0, 0, 5}, {0, std::numeric_limits<double>::quiet_NaN(), -1}}, unit_box, Interval::empty());
}

TEST_CASE("both box intervals hold exactly the points of a random ray that are inside the box") {
  Random random{1};
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    Aabb box;
    box.include(random_point(random));
    box.include(random_point(random));
    Ray ray = random_ray(random);
    if (i % 5 == 0) ray.direction[i % 3] = 0.0;
    const Interval by_cases = box_interval_by_cases(ray, box);
    const Interval branchless = box_interval_branchless(ray, box);
    REQUIRE(by_cases.is_empty() == branchless.is_empty());
    if (!by_cases.is_empty()) {
      ++hits;
      CHECK(by_cases.lower == doctest::Approx(branchless.lower));
      CHECK(is_inside(ray.at(by_cases.lower), box, 1e-9));
      CHECK(is_inside(ray.at(by_cases.upper), box, 1e-9));
    }
    const double t = random.uniform(-2.0, 2.0);
    if (is_inside(ray.at(t), box, -1e-9)) CHECK(by_cases.contains(t));
    if (!is_inside(ray.at(t), box, 1e-9)) CHECK_FALSE(by_cases.contains(t));
  }
  CHECK(hits > 300);
}
