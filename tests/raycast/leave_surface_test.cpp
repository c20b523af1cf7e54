#include "raycast/leave_surface.hpp"

#include <doctest/doctest.h>

#include <velum/velum.hpp>

#include "random_rays.hpp"
#include "raycast/bvh/bvh.hpp"

using namespace velum;

namespace {

struct Body {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;

  TriangleSet set() const { return {positions, triangles}; }
};

/// A ball of flat triangles, perhaps far from the origin.
Body ball(const glm::vec3& at) {
  const Mesh mesh = shapes::icosphere(1.0f, 2);
  Body body{{mesh.positions.begin(), mesh.positions.end()}, {mesh.triangles.begin(), mesh.triangles.end()}};
  for (glm::vec3& p : body.positions) p += at;
  return body;
}

glm::dvec3 normal_of(const Triangle& t) {
  return glm::cross(t.b - t.a, t.c - t.a);
}

SurfacePlace place_of(const Bvh& bvh, const Ray& ray, const RayHit& hit) {
  return {ray.at(hit.t), normal_of(bvh.triangles()[hit.triangle]), position_error(ray, hit.t, bvh.bounds())};
}

bool is_blocked(const Bvh& bvh, const SurfacePlace& place, const glm::dvec3& direction, SelfHitCure cure) {
  CastCounters counters;
  const LeavingRay leaving = leave_surface(place, direction, 1.0, cure, 1e-3);
  const OnSurface on_surface(bvh.triangles(), place);
  const HitFilter filter = cure == SelfHitCure::implicit_sign ? on_surface.filter() : HitFilter{};
  return bvh.is_blocked(leaving.ray, leaving.range, counters, filter);
}

constexpr SelfHitCure cures[] = {SelfHitCure::direction_offset, SelfHitCure::normal_offset,
                                 SelfHitCure::global_epsilon, SelfHitCure::implicit_sign};

/// From the outside of a ball, which is convex but for the rounding of its vertices, steep rays meet nothing.
/// @return shadows that are not there, of 600
int false_shadows(const glm::vec3& at, SelfHitCure cure) {
  const Body body = ball(at);
  const Bvh bvh(body.set());
  Random random{81};
  CastCounters counters;
  int shadows = 0;
  for (int i = 0; i < 600;) {
    const glm::dvec3 from = glm::dvec3(at) + glm::normalize(random_point(random)) * 3.0;
    const Ray ray{from, glm::dvec3(at) + random_point(random, 0.5) - from};
    const RayHit hit = bvh.first_hit(ray, {}, counters);
    if (!hit.is_hit()) continue;
    const SurfacePlace place = place_of(bvh, ray, hit);
    const glm::dvec3 direction = random_point(random, 2.0);
    if (glm::dot(glm::normalize(direction), glm::normalize(place.normal)) < 0.2) continue;
    shadows += is_blocked(bvh, place, direction, cure);
    ++i;
  }
  return shadows;
}

}  // namespace

TEST_CASE("without a cure a surface shadows itself; with each of the four it does not") {
  for (const glm::vec3& at : {glm::vec3(0.0f), glm::vec3(1000.0f, -300.0f, 20.0f)}) {
    CAPTURE(at.x);
    CHECK(false_shadows(at, SelfHitCure::none) > 60);
    for (const SelfHitCure cure : cures) {
      CAPTURE(static_cast<int>(cure));
      CHECK(false_shadows(at, cure) == 0);
    }
  }
}

TEST_CASE(
    "a thing nearer than epsilon is lost to a fixed distance, not to the cures that know the rounding") {
  Body body{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}, {{0, 2, 1}, {0, 3, 2}}};
  for (int i = 0; i < 4; ++i)
    body.positions.push_back(body.positions[static_cast<std::size_t>(i)] + glm::vec3(0, 2e-4f, 0));
  body.triangles.insert(body.triangles.end(), {{4, 6, 5}, {4, 7, 6}});  // a sheet just above the floor
  const Bvh bvh(body.set());
  CastCounters counters;
  const Ray ray{{0.2, -1.0, 0.1}, {0.0, 1.0, 0.0}};
  const RayHit hit = bvh.first_hit(ray, {}, counters);
  const SurfacePlace place = place_of(bvh, ray, hit);
  const glm::dvec3 up{0.05, 1.0, 0.1};
  CHECK(is_blocked(bvh, place, up, SelfHitCure::direction_offset));
  CHECK(is_blocked(bvh, place, up, SelfHitCure::implicit_sign));
  CHECK_FALSE(is_blocked(bvh, place, up, SelfHitCure::normal_offset));
  CHECK_FALSE(is_blocked(bvh, place, up, SelfHitCure::global_epsilon));
}

TEST_CASE("rays that leave end where they should, whatever the cure") {
  const SurfacePlace place{{1, 2, 3}, {0, 0, -2}, 1e-12};
  for (const SelfHitCure cure : cures) {
    const LeavingRay leaving = leave_surface(place, {0.5, 0.5, 0.7}, 1.0, cure, 1e-3);
    CHECK(glm::length(leaving.ray.at(1.0) - glm::dvec3(1.5, 2.5, 3.7)) < 1e-15 * 16);
    CHECK(leaving.range.lower >= 0.0);
    CHECK(leaving.range.lower < 0.01);
    CHECK(leaving.range.upper == 1.0);
  }
  // The flatter, the later; but never without end.
  const auto start = [&](const glm::dvec3& d) {
    return leave_surface(place, d, 1.0, SelfHitCure::direction_offset, 0.0).range.lower;
  };
  CHECK(start({0.0, 0.1, 1.0}) < start({0.0, 1.0, 0.1}));
  CHECK(start({0.0, 1.0, 0.0}) < 1e-8);
}
