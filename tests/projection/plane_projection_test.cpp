#include "projection/plane_projection.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "base/error.hpp"
#include "matrices.hpp"
#include "random.hpp"

using namespace velum;

namespace {

Eigen::Vector4d random_vector(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

bool same_matrix(const glm::dmat4& a, const glm::dmat4& b) {
  const Eigen::Matrix4d x = eigen(a), y = eigen(b);
  return same_up_to_factor(x.reshaped(), y.reshaped());
}

}  // namespace

TEST_CASE("the lecture's worked example: d = 12, (1, 1, 5) goes to 12/17") {
  for (const glm::dmat4& form : {central_onto_xy(12), central_onto_xy_times_d(12)}) {
    const glm::dvec3 image = canonical(form, {1, 1, 5});
    CHECK(image.x == doctest::Approx(12.0 / 17.0).epsilon(1e-15));
    CHECK(image.y == doctest::Approx(12.0 / 17.0).epsilon(1e-15));
    CHECK(image.z == 0.0);
  }
}

TEST_CASE("both homogeneous forms of the central projection are the same projection") {
  CHECK(same_matrix(central_onto_xy(12), central_onto_xy_times_d(12)));
  CHECK((eigen(central_onto_xy(7)) * 7 - eigen(central_onto_xy_times_d(7))).norm() < 1e-14);
}

TEST_CASE("from ever farther away the central projection becomes the orthogonal one") {
  const glm::dvec3 point(1, -2, 5);
  const glm::dvec3 orthogonal = canonical(project_onto_z(), point);
  double last = 1e300;
  for (double d = 10; d < 1e12; d *= 10) {
    const double distance = glm::length(canonical(central_onto_xy(d), point) - orthogonal);
    CHECK(distance < last);
    CHECK(distance < 12.0 / d);
    last = distance;
  }
}

TEST_CASE("a plane projection has determinant 0, rank 3, and its centre as kernel") {
  Random random{1};
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector4d plane = random_vector(random), centre = random_vector(random);
    if (i % 2 == 0) centre[3] = 0;  // a direction
    if (std::abs(plane.dot(centre)) < 1e-2) continue;
    const Eigen::Matrix4d p = eigen(project_onto_plane({plane[0], plane[1], plane[2], plane[3]},
                                                       {centre[0], centre[1], centre[2], centre[3]}));
    const Eigen::Vector4d sizes = p.jacobiSvd().singularValues();
    CHECK(sizes[3] < 1e-14 * sizes[0]);
    CHECK(sizes[2] > 1e-4 * sizes[0]);
    CHECK(same_up_to_factor(kernel(p), centre));
    const Eigen::Vector4d point = random_vector(random), image = p * point;
    CHECK(std::abs(plane.dot(image)) < 1e-14);  // the image lies in the plane
    Eigen::Matrix<double, 4, 3> line;           // and on the line through point and centre
    line << point, centre, image;
    CHECK(line.jacobiSvd().singularValues()[2] < 1e-14);
    CHECK(same_up_to_factor(p * image, image, 1e-9));  // projecting twice is projecting once
  }
}

TEST_CASE("the lecture's projections are instances of the general one") {
  CHECK(same_matrix(project_onto_x(3), project_onto_plane({1, 0, 0, -3}, {1, 0, 0, 0})));
  CHECK(same_matrix(project_onto_y(-2), project_onto_plane({0, 1, 0, 2}, {0, 1, 0, 0})));
  CHECK(same_matrix(project_onto_z(0.5), project_onto_plane({0, 0, 1, -0.5}, {0, 0, 1, 0})));
  CHECK(same_matrix(oblique_onto_xy({1, 2, -4}), project_onto_plane({0, 0, 1, 0}, {1, 2, -4, 0})));
  CHECK(same_matrix(central_onto_xy(12), project_onto_plane({0, 0, 1, 0}, {0, 0, -12, 1})));
  CHECK(same_up_to_factor(kernel(eigen(central_onto_xy(12))), Eigen::Vector4d(0, 0, -12, 1)));
}

TEST_CASE("the lecture's oblique projection follows its formula") {
  const glm::dvec3 image = canonical(oblique_onto_xy({1, 2, -4}), {5, 6, 8});
  CHECK(image == glm::dvec3(5 + 0.25 * 8, 6 + 0.5 * 8, 0));
}

TEST_CASE("projectors that miss the plane are refused") {
  CHECK_THROWS_AS(project_onto_plane({0, 0, 1, 0}, {1, 2, 0, 0}), Error);
  CHECK_THROWS_AS(project_onto_plane({0, 0, 1, -1}, {1, 2, 1, 1}), Error);
  CHECK_THROWS_AS(project_onto_plane({0, 0, 1, 0}, {0, 0, std::numeric_limits<double>::quiet_NaN(), 0}),
                  Error);
  CHECK_THROWS_AS(oblique_onto_xy({1, 1, 0}), Error);
  CHECK_THROWS_AS(central_onto_xy(0), Error);
  CHECK_THROWS_AS(central_onto_xy_times_d(std::numeric_limits<double>::infinity()), Error);
}
