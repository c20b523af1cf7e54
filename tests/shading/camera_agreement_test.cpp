#include <doctest/doctest.h>

#include <cmath>

#include "projection/camera.hpp"
#include "projection/viewing_transform.hpp"
#include "test_cameras.hpp"

namespace {

constexpr velum::Viewport viewport{64, 48};
constexpr double aspect = 64.0 / 48.0;

/// The library's cameras of the same kinds as random_cameras(), from a random place.
std::array<velum::Camera, 3> library_cameras(Random& random) {
  const glm::dmat3 turn = random_rotation(random);
  const velum::Pose pose{turn[2] * random.uniform(1.0, 6.0), -turn[2], turn[1]};
  const glm::dvec2 shear(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8));
  return {velum::Camera::perspective(pose, {}, 0.1, 50.0),
          velum::Camera::parallel(pose, {6.0, {}, 0.0}, 0.1, 50.0),
          velum::Camera::parallel(pose, {6.0, shear, 2.0}, 0.1, 50.0)};
}

TestCamera as_seen_through(const velum::Camera& camera) {
  const glm::dmat4 clip = camera.viewing_transform(aspect).clip_from_world();
  return {clip, {viewport, velum::eye_of(clip), velum::metric_depth_plane(camera)}};
}

}  // namespace

TEST_CASE("facing, the normal's side and metric depth agree under the library's own cameras") {
  Random random{31};
  int tested = 0;
  for (int i = 0; i < 200; ++i) {
    velum::Scene scene;
    scene.add(random_triangle_mesh(random));
    for (const velum::Camera& lens : library_cameras(random)) {
      const TestCamera camera = as_seen_through(lens);
      const velum::TriangleView t = view_of(scene, camera);
      const velum::Plane plane = velum::Plane::through(t.world[0], t.world[1], t.world[2]);
      const double side = velum::side_of_viewer(plane, camera.viewer.eye);
      if (std::abs(side) < 1e-6) continue;
      CHECK((t.determinant > 0.0) == (side > 0.0));
      CHECK((velum::line_of_sight_test(plane, t.world[0], camera.viewer.eye) < 0.0) == (side > 0.0));
      CHECK((t.facing == velum::Facing::front) ==
            (glm::dot(glm::dvec3(t.geometric_normal), plane.normal) > 0.0));
      const velum::Pose& pose = lens.pose();
      const double along_look = glm::dot(glm::normalize(pose.look), t.world[0] - pose.position);
      CHECK(t.metric_depth[0] == doctest::Approx(along_look).epsilon(1e-9));
      ++tested;
    }
  }
  CHECK(tested > 500);
}
