#include <doctest/doctest.h>

#include <limits>

#include "random_scenes.hpp"
#include "raycast/brute_force/brute_force.hpp"
#include "raycast/bvh/bvh.hpp"
#include "raycast/bvh/bvh_refit.hpp"

using namespace velum;

namespace {

RandomTriangles small_triangles(int count) {
  Random random{71};
  RandomTriangles triangles;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 a(random_point(random));
    triangles.add(a, a + glm::vec3(random_point(random, 0.1)), a + glm::vec3(random_point(random, 0.1)));
  }
  return triangles;
}

/// Every vertex on its own by up to `step`: neighbours part.
void move(RandomTriangles& triangles, Random& random, double step) {
  for (glm::vec3& p : triangles.positions) p += glm::vec3(random_point(random, step));
}

/// Whole triangles, each to somewhere else.
void scatter(RandomTriangles& triangles, Random& random) {
  for (std::size_t i = 0; i < triangles.positions.size(); i += 3) {
    const glm::vec3 by(random_point(random));
    for (std::size_t k = 0; k < 3; ++k) triangles.positions[i + k] += by;
  }
}

void check_against_brute_force(const RandomTriangles& triangles, const BvhTree& tree, Random& random) {
  const Bvh bvh(triangles.set(), tree);
  const BruteForce oracle(triangles.set());
  CastCounters counters;
  for (int i = 0; i < 60; ++i) {
    const Ray ray = hard_ray(random, triangles);
    const RayHit expected = oracle.first_hit(ray, {}, counters), found = bvh.first_hit(ray, {}, counters);
    CHECK(found.triangle == expected.triangle);
    CHECK(found.t == expected.t);
  }
}

}  // namespace

TEST_CASE("a refitted hierarchy finds what brute force finds, however far the vertices move") {
  for (const BvhSplit split : {BvhSplit::median, BvhSplit::sah_binned, BvhSplit::agglomerative}) {
    BvhSettings settings;
    settings.split = split;
    Random random{72};
    RandomTriangles triangles = small_triangles(300);
    MovingBvh moving(settings, std::numeric_limits<double>::infinity());
    CHECK(moving.update(triangles.set()));
    for (int frame = 0; frame < 4; ++frame) {
      move(triangles, random, 0.2);
      CHECK_FALSE(moving.update(triangles.set()));
      check_against_brute_force(triangles, moving.tree(), random);
    }
  }
}

TEST_CASE("refitting what has not moved changes nothing") {
  const RandomTriangles triangles = small_triangles(200);
  MovingBvh moving;
  moving.update(triangles.set());
  const BvhTree before = moving.tree();
  CHECK_FALSE(moving.update(triangles.set()));
  CHECK(moving.cost() == moving.cost_when_built());
  REQUIRE(moving.tree().nodes.size() == before.nodes.size());
  for (std::size_t i = 0; i < before.nodes.size(); ++i) {
    CHECK(moving.tree().nodes[i].lower == before.nodes[i].lower);
    CHECK(moving.tree().nodes[i].upper == before.nodes[i].upper);
  }
}

TEST_CASE(
    "a hierarchy is built anew once its cost has grown by the factor, and costs no more than a new one") {
  Random random{73};
  RandomTriangles triangles = small_triangles(400);
  MovingBvh moving({}, 1.5), never({}, std::numeric_limits<double>::infinity());
  moving.update(triangles.set());
  never.update(triangles.set());
  for (glm::vec3& p : triangles.positions) p += glm::vec3(3, 0, 0);  // all together
  CHECK_FALSE(moving.update(triangles.set()));
  CHECK(moving.cost() == doctest::Approx(moving.cost_when_built()).epsilon(1e-3));
  scatter(triangles, random);
  never.update(triangles.set());
  CHECK(never.cost() > never.cost_when_built() * 1.5);
  CHECK(moving.update(triangles.set()));
  CHECK(moving.cost() == moving.cost_when_built());
  CHECK(moving.cost() * 1.5 < never.cost());
  check_against_brute_force(triangles, moving.tree(), random);
}

TEST_CASE("triangles that come, go, or are no longer finite mean a new hierarchy") {
  RandomTriangles triangles = small_triangles(50);
  Random random{74};
  MovingBvh moving;
  moving.update(triangles.set());
  triangles.positions[7].x = std::numeric_limits<float>::quiet_NaN();
  CHECK(moving.update(triangles.set()));
  CHECK(moving.tree().order.size() == 49);
  check_against_brute_force(triangles, moving.tree(), random);
  triangles.positions[7].x = 0.0f;
  CHECK(moving.update(triangles.set()));
  CHECK(moving.tree().order.size() == 50);
  triangles.triangles.pop_back();
  CHECK(moving.update(triangles.set()));
  CHECK(moving.update({}));
  CHECK_FALSE(moving.update({}));
  CHECK(moving.tree().nodes.empty());
}
