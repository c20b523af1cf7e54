#include <doctest/doctest.h>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "base/error.hpp"
#include "matrices.hpp"
#include "projection/camera.hpp"

using namespace velum;

namespace {

const glm::dvec3 eye(3, 2, 5), target(0.5, 0, 0);
const double fov = 0.8, aspect = 1.25, near_plane = 0.5, far_plane = 50;

glm::dmat4 view() {
  return glm::lookAt(eye, target, glm::dvec3(0, 1, 0));
}

const glm::dvec3 points[] = {{0, 0, 0}, {1, 1, 1}, {-2, 0.5, -3}};

void check_same_picture(const Camera& mine, const Camera& theirs) {
  const glm::dmat4 a = mine.viewing_transform(aspect).clip_from_world();
  const glm::dmat4 b = theirs.viewing_transform(aspect).clip_from_world();
  for (const glm::dvec3& point : points) {
    CHECK(glm::length(canonical(a, point) - canonical(b, point)) < 1e-13);
  }
  CHECK(glm::length(theirs.pose().position - mine.pose().position) < 1e-12);
  CHECK(glm::length(theirs.pose().look - glm::normalize(mine.pose().look)) < 1e-13);
}

}  // namespace

TEST_CASE("the clip matrices of OpenGL, Direct3D, Vulkan and reversed z give the picture of our own camera") {
  const Camera mine =
      Camera::perspective(Pose::towards(eye, target), {VerticalAngle{fov}, {}}, near_plane, far_plane);
  const glm::dmat4 flip = glm::scale(glm::dmat4(1.0), glm::dvec3(1, -1, 1));
  const glm::dmat4 gl = glm::perspectiveRH_NO(fov, aspect, near_plane, far_plane) * view();
  const glm::dmat4 d3d = glm::perspectiveRH_ZO(fov, aspect, near_plane, far_plane) * view();
  const glm::dmat4 reversed = glm::perspectiveRH_ZO(fov, aspect, far_plane, near_plane) * view();
  for (const Camera& theirs : {Camera::from_clip_matrix(gl, DepthRange::minus_one_to_one),
                               Camera::from_clip_matrix(d3d, DepthRange::zero_to_one),
                               Camera::from_clip_matrix(flip * d3d, DepthRange::zero_to_one, ClipY::down),
                               Camera::from_clip_matrix(reversed, DepthRange::one_to_zero)}) {
    check_same_picture(mine, theirs);
    CHECK(theirs.is_perspective());
    CHECK(theirs.near() == doctest::Approx(near_plane).epsilon(1e-12));
    CHECK(theirs.far() == doctest::Approx(far_plane).epsilon(1e-12));
    CHECK((eigen(metric_depth_plane(theirs)) - eigen(metric_depth_plane(mine))).norm() < 1e-12);
  }
}

TEST_CASE(
    "an orthographic clip matrix gives the picture of our own camera; its depth starts at the near plane") {
  const glm::dmat4 gl = glm::orthoRH_NO(-2.5, 2.5, -2.0, 2.0, near_plane, far_plane) * view();
  const Camera mine = Camera::parallel(Pose::towards(eye, target), {4, {}, 0}, near_plane, far_plane);
  const Camera theirs = Camera::from_clip_matrix(gl, DepthRange::minus_one_to_one);
  CHECK_FALSE(theirs.is_perspective());
  CHECK(theirs.near() == doctest::Approx(0.0));
  CHECK(theirs.far() == doctest::Approx(far_plane - near_plane));
  const glm::dmat4 a = mine.viewing_transform(aspect).clip_from_world();
  const glm::dmat4 b = theirs.viewing_transform(aspect).clip_from_world();
  for (const glm::dvec3& point : points) {
    CHECK(glm::length(canonical(a, point) - canonical(b, point)) < 1e-13);
    CHECK(glm::dot(metric_depth_plane(theirs), glm::dvec4(point, 1)) ==
          doctest::Approx(glm::dot(metric_depth_plane(mine), glm::dvec4(point, 1)) - near_plane));
  }
  CHECK((eigen(eye_of(b)) - eigen(eye_of(a))).norm() < 1e-13);
}

TEST_CASE("a mirrored parallel picture has its viewer on the same side") {
  const glm::dmat4 gl = glm::orthoRH_ZO(-2.5, 2.5, -2.0, 2.0, near_plane, far_plane) * view();
  const glm::dmat4 mirrored = glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1)) * gl;
  CHECK((eigen(eye_of(mirrored)) - eigen(eye_of(gl))).norm() < 1e-14);
  CHECK(glm::dot(glm::dvec3(eye_of(gl)), eye - target) > 0.0);
}

TEST_CASE("a reversed matrix with its far plane at infinity is welcome") {
  glm::dmat4 infinite(0.0);
  const double f = 1 / std::tan(fov / 2);
  infinite[0][0] = f / aspect;
  infinite[1][1] = f;
  infinite[2][3] = -1;
  infinite[3][2] = near_plane;
  const Camera camera = Camera::from_clip_matrix(infinite * view(), DepthRange::one_to_zero);
  CHECK(camera.near() == doctest::Approx(near_plane));
  CHECK(std::isinf(camera.far()));
  CHECK(glm::length(camera.pose().position - eye) < 1e-12);
}

TEST_CASE("the stages of a clip matrix lead into the canonical volume") {
  const glm::dmat4 any = glm::perspectiveRH_NO(fov, aspect, near_plane, far_plane);
  const ViewingTransform transform =
      Camera::from_clip_matrix(any, DepthRange::minus_one_to_one, ClipY::down).viewing_transform(aspect);
  REQUIRE(transform.stages().size() == 3);
  CHECK(transform.stages()[0].name == "clip matrix");
  CHECK(transform.stages()[1].name == "depth range");
  CHECK(transform.stages()[2].name == "y flip");
  CHECK(canonical(transform.clip_from_world(), {0, 0, -near_plane}).z == doctest::Approx(0.0));
  CHECK(canonical(transform.clip_from_world(), {0, 0, -far_plane}).z == doctest::Approx(1.0));
}

TEST_CASE("a matrix that loses depth, or is not finite, is refused") {
  CHECK_THROWS_AS(Camera::from_clip_matrix(glm::dmat4(0.0), DepthRange::zero_to_one), Error);
  glm::dmat4 flat(1.0);
  flat[2][2] = 0;
  CHECK_THROWS_AS(Camera::from_clip_matrix(flat, DepthRange::zero_to_one), Error);
  CHECK_THROWS_AS(Camera::from_clip_matrix(flat * view(), DepthRange::zero_to_one), Error);
  glm::dmat4 broken(1.0);
  broken[1][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(Camera::from_clip_matrix(broken, DepthRange::zero_to_one), Error);
  // Far from the origin, with a deep range: badly scaled, but regular.
  const glm::dmat4 moved = glm::translate(glm::dmat4(1.0), glm::dvec3(1e6, -1e6, 1e6));
  CHECK_NOTHROW(Camera::from_clip_matrix(glm::perspectiveRH_NO(fov, aspect, 0.01, 1e5) * moved,
                                         DepthRange::minus_one_to_one));
}
