#include <doctest/doctest.h>

#include <algorithm>
#include <velum/velum.hpp>

using namespace velum;

namespace {

const Pose pose = Pose::towards({13.0, 9.0, 22.0}, {0.0, 0.5, 0.0});

Scene house() {
  Scene scene;
  scene.add(builtin_shape("house"));
  return scene;
}

RenderSettings settings_of(int width, int height) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  return settings;
}

/// The distance of the scene's farthest vertex along the look vector, as near as double gets to it.
double farthest_vertex(const Scene& scene) {
  double farthest = 0.0;
  const glm::dvec3 look = glm::normalize(pose.look);
  for (const glm::vec3& position : scene.meshes()[0].positions) {
    farthest = std::max(farthest, glm::dot(look, glm::dvec3(position) - pose.position));
  }
  return farthest;
}

AgreementReport report_of(const Scene& scene, double near, double far) {
  return agree(scene, Camera::perspective(pose, {VerticalAngle{0.2}}, near, far), settings_of(120, 90));
}

}  // namespace

TEST_CASE("raster and ray casting agree at every far / near that a camera may have") {
  const Scene scene = house();
  for (double ratio = 10.0; ratio < 1.001 * largest_far_over_near; ratio *= 10.0) {
    CAPTURE(ratio);
    const AgreementReport report = report_of(scene, 40.0 / (0.999 * ratio), 40.0);
    CHECK(report.is_explained());
    CHECK(report.covered > 400);
    CHECK(report.differing_share() < 0.01);
    CHECK(report_of(scene, 10.0, std::max(10.0 * ratio * 0.999, 40.0)).is_explained());
  }
}

TEST_CASE("raster and ray casting agree where the far plane touches the scene") {
  const Scene scene = house();
  const double touching = farthest_vertex(scene);
  for (const double ratio : {1e3, 1e9, 1e11, 9.9e11}) {
    for (const double beyond : {-1e-5, -1e-9, 0.0, 1e-9, 1e-5}) {
      CAPTURE(ratio);
      CAPTURE(beyond);
      const double far = touching * (1.0 + beyond);
      CHECK(report_of(scene, far / ratio, far).is_explained());
    }
  }
}

TEST_CASE("a wall in the far plane itself is cut, and seen by both or by one") {
  // Across the look vector, in the far plane as far as float32 can be: the raster's z and w, and the ray's t,
  // each round to one of the plane's two sides.
  Scene scene;
  Mesh wall;
  wall.positions = {glm::vec3(-1, -1, -3), glm::vec3(1.5f, -1, -3), glm::vec3(0, 1.25f, -3)};
  wall.triangles = {glm::uvec3(0, 1, 2)};
  scene.add(wall, glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0),
                             glm::dvec4(0.1, 0.2, 0.3, 1)));
  int differing = 0;
  for (const double yaw : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}) {
    const Pose across{{0.1 + yaw, 0.2, 1.3}, {0.0, 0.0, -1.0}, {yaw, 1.0, 0.0}};
    for (const double near : {1.0, 1e-3, 1e-7, 1e-10, 4.1e-12}) {
      CAPTURE(near);
      const Camera camera = Camera::perspective(across, {VerticalAngle{0.6}}, near, 4.0);
      const AgreementReport report = agree(scene, camera, settings_of(40, 40));
      CHECK(report.is_explained());
      differing += report.of(Agreement::cut) > 100;
    }
  }
  CHECK(differing > 0);
}

TEST_CASE("raster and ray casting agree where a clip matrix takes all digits from depth") {
  // The eye stands in the origin, so that the matrix is regular however small near is.
  const StageList stages =
      Camera::perspective(pose, {VerticalAngle{0.2}}, 1.0, 40.0).viewing_transform(1.0).stages();
  Scene scene;
  scene.add(builtin_shape("house"), stages[1].matrix * stages[0].matrix);
  for (const double near : {1e-3, 1e-9, 1e-13, 1e-15, 1e-17, 1e-30, 1e-45, 1e-100}) {
    for (const double far : {40.0, 1e9, 1e100}) {
      CAPTURE(near);
      CAPTURE(far);
      glm::dmat4 clip(0.0);
      clip[0][0] = clip[1][1] = 9.0;
      clip[2][2] = far / (near - far);
      clip[3][2] = near * clip[2][2];
      clip[2][3] = -1.0;
      const Camera camera = Camera::from_clip_matrix(clip, DepthRange::zero_to_one);
      const AgreementReport report = agree(scene, camera, settings_of(90, 90));
      CHECK(report.is_explained());
      CHECK(report.covered > 350);
    }
  }
}

TEST_CASE("raster and ray casting agree at every depth range that a parallel camera may have") {
  const Scene scene = house();
  const ParallelWindow window{4.0, {0.3, 0.2}, 0.0};
  for (double depth = 1e2; depth < 4.1 * largest_depth_in_windows; depth *= 10.0) {
    CAPTURE(depth);
    const double reach = std::min(depth, 4.0 * largest_depth_in_windows);
    CHECK(agree(scene, Camera::parallel(pose, window, -reach, reach), settings_of(120, 90)).is_explained());
    CHECK(agree(scene, Camera::parallel(pose, window, 0.0, reach), settings_of(120, 90)).is_explained());
  }
}
