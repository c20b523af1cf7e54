#include "projection/camera.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

#include "base/elementary.hpp"
#include "base/error.hpp"
#include "matrices.hpp"
#include "projection/viewport.hpp"
#include "random.hpp"

using namespace velum;

namespace {

const Pose pose{{1, 2, 3}, {-0.3, -0.5, -2}, {0.1, 1, 0.2}};

double gap(const glm::dmat4& a, const Eigen::Matrix4d& b) {
  return (eigen(a) - b).norm() / b.norm();
}

Eigen::Matrix4d hinge(double near, double far) {
  const double k = near / far;
  Eigen::Matrix4d d = Eigen::Matrix4d::Identity();
  d.row(2) << 0, 0, 1 / (k - 1), k / (k - 1);
  d.row(3) << 0, 0, -1, 0;
  return d;
}

Eigen::Matrix4d view(const Pose& p) {
  return turn(p.look, p.up) * translation(-p.position.x, -p.position.y, -p.position.z);
}

glm::dvec3 along(const Pose& p, double distance) {
  const Eigen::Vector3d look = eigen(p.look).normalized() * distance;
  return p.position + glm::dvec3(look[0], look[1], look[2]);
}

std::string names(const Camera& camera, double aspect = 1.0) {
  std::string result;
  const ViewingTransform transform = camera.viewing_transform(aspect);
  for (const Stage& stage : transform.stages()) {
    CHECK(stage.meaning.back() == '.');
    result += std::string(stage.name) + " ";
  }
  return result;
}

std::vector<Camera> various_cameras() {
  return {Camera::perspective(pose, {}, 0.5, 40),
          Camera::perspective(pose, {HorizontalAngle{1.2}, {0.2, -0.7}}, 1, 1000),
          Camera::perspective(pose, {FocalLength{35, 24}, {}}, 0.01, 100),
          Camera::off_axis(pose, {-1, 0.5, -0.2, 0.8}, 1, 10),
          Camera::parallel(pose, {3, {}, 0}, 1, 9),
          Camera::parallel(pose, {3, {-0.4, 0.3}, 5}, -4, 9)};
}

double aspect_of(const Camera& camera) {
  return camera.aspect().value_or(1.6);
}

}  // namespace

TEST_CASE("the perspective composite is D S_xyz S_xy M_rot^T T(-COP)") {
  const double near = 0.5, far = 40, aspect = 1.5;
  const Camera camera = Camera::perspective(pose, {VerticalAngle{0.8}, {}}, near, far);
  const double t = std::tan(0.4);
  const Eigen::Matrix4d expected = hinge(near, far) * scaling(1 / far, 1 / far, 1 / far) *
                                   scaling(1 / (aspect * t), 1 / t, 1) * view(pose);
  CHECK(gap(camera.viewing_transform(aspect).clip_from_world(), expected) < 1e-15);
  CHECK(names(camera) == "T(-COP) M_rot^T S_xy S_xyz(1/far) D ");
}

TEST_CASE("the parallel composite is S(2/w, 2/h, -1/(far-near)) T(0,0,near) [shear] M_rot^T T(-COP)") {
  const double near = -4, far = 9, aspect = 1.5, height = 3;
  const Eigen::Matrix4d volume =
      scaling(2 / (height * aspect), 2 / height, -1 / (far - near)) * translation(0, 0, near);
  const Camera upright = Camera::parallel(pose, {height, {}, 0}, near, far);
  CHECK(gap(upright.viewing_transform(aspect).clip_from_world(), volume * view(pose)) < 1e-15);
  CHECK(names(upright) == "T(-COP) M_rot^T T(0,0,near) S(2/w,2/h,1/(far-near)) S(1,1,-1) ");

  Eigen::Matrix4d shear = Eigen::Matrix4d::Identity();
  shear.row(0) << 1, 0, -0.4, -0.4 * 5;
  shear.row(1) << 0, 1, 0.3, 0.3 * 5;
  const Camera oblique = Camera::parallel(pose, {height, {-0.4, 0.3}, 5}, near, far);
  CHECK(gap(oblique.viewing_transform(aspect).clip_from_world(), volume * shear * view(pose)) < 1e-15);
  CHECK(names(oblique) == "T(-COP) M_rot^T Sh_oblique T(0,0,near) S(2/w,2/h,1/(far-near)) S(1,1,-1) ");
}

TEST_CASE("near goes to z = 0 and far to z = 1") {
  for (const Camera& camera : various_cameras()) {
    const glm::dmat4 clip = camera.viewing_transform(aspect_of(camera)).clip_from_world();
    CHECK(canonical(clip, along(pose, camera.near())).z == doctest::Approx(0.0).epsilon(1e-12));
    CHECK(canonical(clip, along(pose, camera.far())).z == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(eigen(clip).determinant() != 0.0);  // regular: nothing of depth is lost
  }
}

TEST_CASE("an off-axis frustum equals the formula of glFrustum") {
  const double l = -1, r = 0.5, b = -0.2, t = 0.8, n = 1, f = 10;
  Eigen::Matrix4d gl;
  gl << 2 * n / (r - l), 0, (r + l) / (r - l), 0, 0, 2 * n / (t - b), (t + b) / (t - b), 0, 0, 0,
      -(f + n) / (f - n), -2 * f * n / (f - n), 0, 0, -1, 0;
  Eigen::Matrix4d range = Eigen::Matrix4d::Identity();
  range.row(2) << 0, 0, 0.5, 0.5;
  const Camera camera = Camera::off_axis({}, {l, r, b, t}, n, f);
  const glm::dmat4 clip = camera.viewing_transform(1.5).clip_from_world();
  // Ours carries the factor 1/far of S_xyz: the same projection.
  CHECK(gap(clip, range * gl / f) < 1e-15);
  CHECK(names(camera, 1.5) == "T(-COP) M_rot^T Sh_lens S_xy S_xyz(1/far) D ");
}

TEST_CASE("a lens shift of half a width puts the principal point on the left edge") {
  const Camera camera = Camera::perspective({}, {VerticalAngle{0.9}, {0.5, 0.0}}, 1, 10);
  CHECK(canonical(camera.viewing_transform(2).clip_from_world(), {0, 0, -5}).x == doctest::Approx(-1.0));
  const Camera raised = Camera::perspective({}, {VerticalAngle{0.9}, {0.0, 0.25}}, 1, 10);
  CHECK(canonical(raised.viewing_transform(2).clip_from_world(), {0, 0, -5}).y == doctest::Approx(-0.5));
}

TEST_CASE("vertical angle, horizontal angle and focal length say the same") {
  const double vertical = 0.7, aspect = 1.6;
  const auto clip = [&](const Opening& opening) {
    return eigen(Camera::perspective(pose, {opening, {}}, 1, 9).viewing_transform(aspect).clip_from_world());
  };
  const Eigen::Matrix4d expected = clip(VerticalAngle{vertical});
  CHECK((clip(HorizontalAngle{2 * std::atan(aspect * std::tan(vertical / 2))}) - expected).norm() < 1e-15);
  CHECK((clip(FocalLength{50, 100 * std::tan(vertical / 2)}) - expected).norm() < 1e-15);
}

TEST_CASE("an opening angle near 0, from far away, tends to the orthographic picture") {
  const glm::dvec3 point(0.3, -0.2, 0.4);
  const Camera flat = Camera::parallel({{0, 0, 10}, {0, 0, -1}, {0, 1, 0}}, {2, {}, 0}, 9, 11);
  const glm::dvec3 expected = canonical(flat.viewing_transform(1).clip_from_world(), point);
  double last = 1e300;
  for (double d = 10; d < 1e8; d *= 10) {
    const Camera camera =
        Camera::perspective({{0, 0, d}, {0, 0, -1}, {0, 1, 0}}, {FocalLength{d, 2}, {}}, d - 1, d + 1);
    const double distance =
        glm::length(canonical(camera.viewing_transform(1).clip_from_world(), point) - expected);
    CHECK(distance < last);
    last = distance;
  }
  CHECK(last < 1e-6);
}

TEST_CASE("stage by stage the images of a point end at the product") {
  for (const Camera& camera : various_cameras()) {
    const ViewingTransform transform = camera.viewing_transform(aspect_of(camera));
    const glm::dvec4 point(0.3, -1, 0.5, 1);
    const std::vector<glm::dvec4> images = transform.images_of(point);
    REQUIRE(images.size() == transform.stages().size() + 1);
    CHECK(images.front() == point);
    const Eigen::Vector4d end = eigen(transform.clip_from_world()) * eigen(point);
    CHECK((eigen(images.back()) - end).norm() < 1e-14 * end.norm());
    const Eigen::Matrix4d identity = eigen(transform.world_from_clip()) * eigen(transform.clip_from_world());
    CHECK((identity - Eigen::Matrix4d::Identity()).norm() < 1e-12);
  }
}

TEST_CASE("scene and camera moved far together keep the composite") {
  const glm::dvec3 far_away(1e4, -1e4, 1e4);
  const Pose moved{pose.position + far_away, pose.look, pose.up};
  glm::dmat4 model(1.0);
  model[3] = glm::dvec4(far_away, 1.0);
  const glm::dmat4 here = Camera::perspective(pose, {}, 1, 9).viewing_transform(1).clip_from_world();
  const glm::dmat4 there = Camera::perspective(moved, {}, 1, 9).viewing_transform(1).clip_from_object(model);
  CHECK(gap(there, eigen(here)) < 1e-15);
}

TEST_CASE("the eye is the kernel of rows x, y, w: the COP, or the direction against the projectors") {
  for (const Camera& camera : various_cameras()) {
    const glm::dmat4 clip = camera.viewing_transform(aspect_of(camera)).clip_from_world();
    const glm::dvec4 eye = eye_of(clip);
    CHECK(same_up_to_factor(kernel(rows_xyw(eigen(clip))), eigen(eye), 1e-11));
    if (camera.is_perspective()) {
      CHECK(eye.w == 1.0);
      CHECK(glm::length(glm::dvec3(eye) - pose.position) < 1e-13);
    } else {
      CHECK(eye.w == 0.0);
      CHECK(glm::length(glm::dvec3(eye)) == doctest::Approx(1.0));
      CHECK(glm::dot(glm::dvec3(eye), pose.look) < 0.0);  // the viewer's side
    }
  }
  CHECK_THROWS_AS(eye_of(glm::dmat4(0.0)), Error);
}

TEST_CASE("facing by the eye agrees with the winding on the picture, in every projection") {
  Random random{2};
  for (const Camera& camera : various_cameras()) {
    const glm::dmat4 clip = camera.viewing_transform(aspect_of(camera)).clip_from_world();
    const glm::dvec4 eye = eye_of(clip);
    const auto inside = [&] {
      const glm::dvec4 p = camera.viewing_transform(aspect_of(camera)).world_from_clip() *
                           glm::dvec4(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 1), 1);
      return glm::dvec3(p) / p.w;
    };
    for (int i = 0; i < 50; ++i) {
      const glm::dvec3 a = inside(), b = inside(), c = inside();
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const double facing = glm::dot(glm::dvec4(normal, -glm::dot(normal, a)), eye);
      const glm::dvec3 u = canonical(clip, a), v = canonical(clip, b), w = canonical(clip, c);
      const double winding = (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
      CHECK((facing > 0) == (winding > 0));
    }
  }
}

TEST_CASE("metric depth is the distance along the look vector, oblique or not") {
  const Eigen::Vector3d look = eigen(pose.look).normalized();
  for (const Camera& camera : various_cameras()) {
    const glm::dvec4 plane = metric_depth_plane(camera);
    const Eigen::Vector3d point(0.3, -4, 2);
    const double expected = look.dot(point - eigen(pose.position));
    CHECK(eigen(plane).dot(Eigen::Vector4d(point[0], point[1], point[2], 1)) == doctest::Approx(expected));
  }
}

TEST_CASE("what cannot be a camera is refused with the parameter's name") {
  const auto refuses = [](const char* name, auto make) {
    CAPTURE(name);
    try {
      make();
      FAIL("accepted");
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::usage);
      CHECK(std::string(error.what()).find(name) != std::string::npos);
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  refuses("up", [] { Camera::perspective({{0, 0, 0}, {0, 5, 0}, {0, -2, 0}}, {}, 1, 2); });
  refuses("up", [] { Camera::perspective({{0, 0, 0}, {0, 1e-200, 0}, {0, 1e200, 0}}, {}, 1, 2); });
  refuses("up", [] { Camera::parallel({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {}, 1, 2); });
  refuses("look", [] { Camera::perspective({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {}, 1, 2); });
  refuses("look", [&] { Camera::perspective({{0, 0, 0}, {nan, 0, 0}, {0, 1, 0}}, {}, 1, 2); });
  refuses("position", [&] { Camera::perspective({{0, infinity, 0}, {1, 0, 0}, {0, 1, 0}}, {}, 1, 2); });
  refuses("near", [] { Camera::perspective(pose, {}, 2, 2); });
  refuses("near", [] { Camera::perspective(pose, {}, 3, 2); });
  refuses("near", [] { Camera::perspective(pose, {}, 0, 2); });
  refuses("near", [] { Camera::perspective(pose, {}, -1, 2); });
  refuses("near", [] { Camera::parallel(pose, {}, 2, 2); });
  refuses("near", [&] { Camera::parallel(pose, {}, nan, 2); });
  refuses("far", [&] { Camera::perspective(pose, {}, 1, infinity); });
  refuses("vertical", [] { Camera::perspective(pose, {VerticalAngle{0}, {}}, 1, 2); });
  refuses("vertical", [] { Camera::perspective(pose, {VerticalAngle{pi}, {}}, 1, 2); });
  refuses("horizontal", [&] { Camera::perspective(pose, {HorizontalAngle{nan}, {}}, 1, 2); });
  refuses("focal", [] { Camera::perspective(pose, {FocalLength{0, 24}, {}}, 1, 2); });
  refuses("film", [] { Camera::perspective(pose, {FocalLength{35, -24}, {}}, 1, 2); });
  refuses("shift", [&] { Camera::perspective(pose, {VerticalAngle{1}, {nan, 0}}, 1, 2); });
  refuses("aspect", [] { Camera::perspective(pose, {}, 1, 2, 0.0); });
  refuses("aspect", [] { Camera::parallel(pose, {}, 1, 2, -1.0); });
  refuses("height", [] { Camera::parallel(pose, {0, {}, 0}, 1, 2); });
  refuses("shear", [&] { Camera::parallel(pose, {1, {0, infinity}, 0}, 1, 2); });
  refuses("focus", [&] { Camera::parallel(pose, {1, {}, nan}, 1, 2); });
  refuses("left", [] { Camera::off_axis(pose, {1, 1, 0, 1}, 1, 2); });
  refuses("bottom", [] { Camera::off_axis(pose, {0, 1, 2, 1}, 1, 2); });
  refuses("aspect", [] { Camera::perspective(pose, {}, 1, 2, 1.5).viewing_transform(1.4); });
  refuses("aspect", [] { Camera::perspective(pose, {}, 1, 2).viewing_transform(0.0); });
}

TEST_CASE("a camera whose depth would have no digits is refused, whatever its numbers") {
  const auto refuses = [](auto make) {
    try {
      make();
      FAIL("accepted");
    } catch (const Error& error) {
      CHECK(std::string(error.what()).find("leaves depth no digits (near ") != std::string::npos);
    }
  };
  for (const double near : {1e-60, 1e-3, 1.0, 1e60}) {
    const double most = near * largest_far_over_near;
    CAPTURE(near);
    CHECK_NOTHROW(Camera::perspective(pose, {}, near, most * 0.999));
    CHECK_NOTHROW(Camera::off_axis(pose, {-near, near, -near, near}, near, most * 0.999));
    for (const double far : {most * 1.001, most * 1e4, most * 1e90}) {
      refuses([&] { Camera::perspective(pose, {}, near, far); });
      refuses([&] { Camera::off_axis(pose, {-near, near, -near, near}, near, far); });
    }
  }
  // What is written in the very ratio is not more, though 5e-28 / 5e-40 is in double.
  CHECK(5e-28 / 5e-40 > largest_far_over_near);
  CHECK_NOTHROW(Camera::perspective(pose, {}, 5e-40, 5e-28));
  CHECK_NOTHROW(Camera::perspective(pose, {}, 1e-3, 1e9));
  const double deepest = 3.0 * largest_depth_in_windows;
  const ParallelWindow window{3.0, {}, 0.0};
  CHECK_NOTHROW(Camera::parallel(pose, window, -0.999 * deepest, 0.999 * deepest));
  refuses([&] { Camera::parallel(pose, window, 0.0, 1.001 * deepest); });
  refuses([&] { Camera::parallel(pose, window, -1.001 * deepest, 0.0); });
  refuses([&] { Camera::parallel(pose, window, -1e200, 1e200); });
}

TEST_CASE("an aspect of the camera's own is kept within the tolerance") {
  const Camera camera = Camera::perspective(pose, {}, 1, 2, 1.5);
  CHECK_NOTHROW(camera.viewing_transform(1.5));
  CHECK_NOTHROW(camera.viewing_transform(1.5 * (1 + 1e-10)));
  CHECK_NOTHROW(camera.viewing_transform(1.49, 0.01));
  CHECK_THROWS_AS(camera.viewing_transform(1.49), Error);
}

TEST_CASE("the viewport has (0, 0) at the top left, y down") {
  const Viewport viewport{640, 480};
  CHECK(viewport.pixel_from_ndc(-1, 1) == glm::dvec2(0, 0));
  CHECK(viewport.pixel_from_ndc(1, -1) == glm::dvec2(640, 480));
  CHECK(viewport.pixel_from_ndc(0, 0) == glm::dvec2(320, 240));
  CHECK(viewport.ndc_from_pixel(480, 120) == glm::dvec2(0.5, 0.5));
}
