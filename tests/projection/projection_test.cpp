#include "projection/projection.hpp"

#include <doctest/doctest.h>

#include <complex>
#include <numeric>

#include "base/error.hpp"
#include "matrices.hpp"
#include "projection/frame.hpp"
#include "random.hpp"

using namespace velum;
namespace named = velum::projection;

namespace {

using Complex = std::complex<double>;
using Axes = std::array<Complex, 3>;

const Aabb unit_cube{{0, 0, 0}, {1, 1, 1}};

glm::dmat4 clip_of(const Camera& camera) {
  return camera.viewing_transform(1.0).clip_from_world();
}

// The edges of the unit cube as drawn by the camera that frame() makes: world units on the picture plane.
Axes drawn_axes(const Projection& projection) {
  const Camera camera = frame(unit_cube, projection);
  const glm::dmat4 clip = clip_of(camera);
  const double unit = 0.5 * std::get<ParallelWindow>(camera.lens()).height;
  const glm::dvec3 origin = canonical(clip, {0, 0, 0});
  Axes axes;
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 end(0.0);
    end[i] = 1.0;
    const glm::dvec3 edge = (canonical(clip, end) - origin) * unit;
    axes[static_cast<std::size_t>(i)] = {edge.x, edge.y};
  }
  return axes;
}

double sum_of_squared_lengths(const Axes& p) {
  return std::norm(p[0]) + std::norm(p[1]) + std::norm(p[2]);
}
Complex gauss_sum(const Axes& p) {
  return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
}

void check_axes(const Projection& projection, const std::array<double, 3>& degrees_of,
                const std::array<double, 3>& scales, double tolerance) {
  CAPTURE(projection.name);
  const Axes axes = drawn_axes(projection);
  for (std::size_t i = 0; i < 3; ++i) {
    CAPTURE(i);
    CHECK(std::abs(axes[i] - std::polar(scales[i], radians(degrees_of[i]))) < tolerance);
  }
}

std::vector<Projection> parallel_projections() {
  std::vector<Projection> result;
  for (const ProjectionEntry& entry : projection_catalogue()) {
    if (entry.family != "perspective") result.push_back(parse_projection(entry.name));
  }
  return result;
}

int finite_vanishing_points(const Projection& projection) {
  const glm::dmat4 clip = clip_of(frame(unit_cube, projection));
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(clip[axis][3]) > 1e-12 * glm::length(glm::dvec3(clip[axis]))) ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("the principal views draw their two axes 1:1 and lose the third") {
  const auto axes = [](const Projection& p) { return drawn_axes(p); };
  const Complex right(1, 0), up(0, 1), none(0, 0);
  const std::pair<Projection, Axes> expected[] = {
      {named::front(), {right, up, none}}, {named::back(), {-right, up, none}},
      {named::left(), {none, up, right}},  {named::right(), {none, up, -right}},
      {named::top(), {right, none, -up}},  {named::bottom(), {right, none, up}},
  };
  for (const std::pair<Projection, Axes>& row : expected) {
    CAPTURE(row.first.name);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(axes(row.first)[i] - row.second[i]) < 1e-14);
  }
}

TEST_CASE("the orthographic presets draw the axes of PROJECTIONS' tables") {
  const double third = std::sqrt(2.0 / 3.0);
  check_axes(named::isometric(), {-30, 90, 210}, {third, third, third}, 1e-14);
  check_axes(named::isometric(), {-30, 90, 210}, {0.816497, 0.816497, 0.816497}, 1e-6);
  check_axes(named::dimetric(), {-7.180756, 90, 221.409622}, {0.942809, 0.942809, 0.471405}, 1e-6);
  check_axes(named::dimetric_2to1(), {-26.565051, 90, 206.565051}, {0.790569, 0.866025, 0.790569}, 1e-6);
  const Axes dimetric = drawn_axes(named::dimetric());
  CHECK(std::abs(dimetric[2]) / std::abs(dimetric[0]) == doctest::Approx(0.5).epsilon(1e-14));
  CHECK(std::arg(dimetric[0]) == doctest::Approx(-std::asin(1.0 / 8)).epsilon(1e-14));
  CHECK(std::arg(dimetric[2]) + pi == doctest::Approx(std::acos(0.75)).epsilon(1e-14));
}

TEST_CASE("the oblique presets draw a true front face and the receding axis at its angle and scale") {
  check_axes(named::cavalier(), {0, 90, 225}, {1, 1, 1}, 1e-14);
  check_axes(named::cabinet(), {0, 90, 225}, {1, 1, 0.5}, 1e-14);
  check_axes(named::natural_oblique(), {0, 90, 225}, {1, 1, 2.0 / 3.0}, 1e-14);
  check_axes(named::oblique(radians(30), 0.7), {0, 90, 210}, {1, 1, 0.7}, 1e-14);
  check_axes(named::military(), {-45, 90, 225}, {1, 1, 1}, 1e-14);
  check_axes(named::military(radians(30), 2.0 / 3.0), {-30, 90, 240}, {1, 2.0 / 3.0, 1}, 1e-14);
}

TEST_CASE("projectors of the oblique presets meet the picture plane at atan(1/L)") {
  const auto angle = [](const Projection& p) {
    const glm::dvec3 eye(eye_of(clip_of(frame(unit_cube, p))));
    return degrees(std::asin(glm::min(1.0, glm::dot(eye, -p.look))));
  };
  CHECK(angle(named::cavalier()) == doctest::Approx(45.0));
  CHECK(angle(named::cabinet()) == doctest::Approx(63.434949));
  CHECK(angle(named::natural_oblique()) == doctest::Approx(56.309932));
  CHECK(angle(named::military()) == doctest::Approx(45.0));
  CHECK(angle(named::isometric()) == doctest::Approx(90.0));
}

TEST_CASE("a cabinet cube shows front, right and top; a planometric one its roof and two walls") {
  const auto shown = [](const Projection& p) {
    const glm::dvec3 eye(eye_of(clip_of(frame(unit_cube, p))));
    std::string faces;
    for (const auto& [name, normal] : {std::pair<const char*, glm::dvec3>{"right ", {1, 0, 0}},
                                       {"left ", {-1, 0, 0}},
                                       {"top ", {0, 1, 0}},
                                       {"bottom ", {0, -1, 0}},
                                       {"front ", {0, 0, 1}},
                                       {"back ", {0, 0, -1}}}) {
      if (glm::dot(normal, eye) > 1e-12) faces += name;
    }
    return faces;
  };
  for (const Projection& p : {named::cabinet(), named::cavalier(), named::natural_oblique(),
                              named::military(), named::isometric(), named::dimetric(), named::trimetric()}) {
    CAPTURE(p.name);
    CHECK(shown(p) == "right top front ");
  }
  CHECK(shown(named::front()) == "front ");
}

TEST_CASE("orthographic: the squared lengths of the axes add to 2, and Gauss' sum of squares is 0") {
  Random random{3};
  for (int i = 0; i < 100; ++i) {
    const Axes axes = drawn_axes(named::orthographic(random.uniform(-1.5, 1.5), random.uniform(-6, 6)));
    CHECK(sum_of_squared_lengths(axes) == doctest::Approx(2.0).epsilon(1e-13));
    CHECK(std::abs(gauss_sum(axes)) < 1e-13);
  }
  for (const Projection& p : parallel_projections()) {
    if (p.family != ProjectionFamily::orthographic) continue;
    CAPTURE(p.name);
    CHECK(sum_of_squared_lengths(drawn_axes(p)) == doctest::Approx(2.0).epsilon(1e-14));
    CHECK(std::abs(gauss_sum(drawn_axes(p))) < 1e-14);
  }
}

TEST_CASE("oblique: the squared lengths add to 2 + L^2, Gauss' sum is L^2 exp(2 i phi)") {
  Random random{4};
  for (int i = 0; i < 100; ++i) {
    const double phi = random.uniform(-6, 6), l = random.uniform(0.1, 2);
    const Axes axes = drawn_axes(named::oblique(phi, l));
    CHECK(sum_of_squared_lengths(axes) == doctest::Approx(2 + l * l).epsilon(1e-13));
    CHECK(std::abs(gauss_sum(axes) - std::polar(l * l, 2 * phi)) < 1e-13);
    const Axes plan = drawn_axes(named::military(phi, l));
    CHECK(sum_of_squared_lengths(plan) == doctest::Approx(2 + l * l).epsilon(1e-13));
    CHECK(std::abs(gauss_sum(plan) + l * l) < 1e-13);  // φ = 270°
  }
}

TEST_CASE("axonometry: any three pictures of the axes are met, whatever they are (Pohlke)") {
  Random random{5};
  int tried = 0;
  while (tried < 500) {
    std::array<double, 3> angles{}, scales{};
    Eigen::Matrix<double, 2, 3> a;
    for (std::size_t i = 0; i < 3; ++i) {
      angles[i] = random.uniform(-6, 6);
      scales[i] = tried % 5 == 0 && i == 0 ? 0.0 : random.uniform(0.2, 2);
      a.col(static_cast<int>(i)) << scales[i] * std::cos(angles[i]), scales[i] * std::sin(angles[i]);
    }
    const double smallest = a.jacobiSvd().singularValues()[1];
    if (smallest < 0.05) continue;
    ++tried;
    const Projection p = named::axonometry(angles, scales);
    const Axes drawn = drawn_axes(p);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(std::abs(drawn[i] * smallest - std::polar(scales[i], angles[i])) < 1e-12);
    }
    CHECK(std::abs(glm::dot(p.look, p.up)) < 1e-12);
    CHECK(glm::length(p.look) == doctest::Approx(1.0).epsilon(1e-12));
    // Seen from the side of a1 × a2: front faces stay front.
    const Eigen::Vector3d normal = a.row(0).transpose().cross(a.row(1).transpose()).normalized();
    const Eigen::Vector4d eye = eigen(eye_of(clip_of(frame(unit_cube, p))));
    CHECK((eye.head<3>() - normal).norm() < 1e-11);
  }
}

TEST_CASE("axonometry finds the special projections among all: isometric, dimetric, cabinet, military") {
  const auto same = [](const Projection& found, const Projection& expected) {
    CAPTURE(expected.name);
    CHECK(glm::length(found.look - expected.look) < 1e-7);
    CHECK(glm::length(found.up - expected.up) < 1e-7);
    CHECK(glm::length(found.shear - expected.shear) < 1e-7);
  };
  same(named::axonometry({radians(-30), radians(90), radians(210)}, {1, 1, 1}), named::isometric());
  same(named::axonometry({std::atan2(-1, std::sqrt(63.0)), radians(90), pi + std::acos(0.75)}, {1, 1, 0.5}),
       named::dimetric());
  same(named::axonometry({0, radians(90), radians(225)}, {1, 1, 0.5}), named::cabinet());
  same(named::axonometry({0, radians(90), radians(225)}, {1, 1, 1}), named::cavalier());
  same(named::axonometry({radians(-45), radians(90), radians(225)}, {1, 1, 1}), named::military());
  same(named::axonometry({0, radians(90), 0}, {1, 1, 0}), named::front());
}

TEST_CASE("ISO's nominal dimetric, 7 and 42 degrees with 1 : 1 : 1/2, is parallel but slightly oblique") {
  const Projection p = named::axonometry({radians(-7), radians(90), radians(222)}, {1, 1, 0.5});
  const Axes drawn = drawn_axes(p);
  CHECK(degrees(std::arg(drawn[0])) == doctest::Approx(-7));
  CHECK(degrees(std::arg(drawn[2])) == doctest::Approx(222 - 360));
  CHECK(std::abs(drawn[2]) / std::abs(drawn[0]) == doctest::Approx(0.5));
  CHECK(std::abs(drawn[1]) / std::abs(drawn[0]) == doctest::Approx(1.0));
  CHECK(glm::length(p.shear) > 1e-3);
  CHECK(glm::length(p.shear) < 0.2);
}

TEST_CASE("parallel projections keep parallels and ratios along one direction") {
  Random random{6};
  const auto point = [&] { return glm::dvec3(random.uniform(), random.uniform(), random.uniform()); };
  for (const Projection& p : parallel_projections()) {
    CAPTURE(p.name);
    const glm::dmat4 clip = clip_of(frame(unit_cube, p));
    const glm::dvec3 a = point(), b = point(), direction = point();
    const glm::dvec3 one = canonical(clip, a + direction) - canonical(clip, a);
    const glm::dvec3 three = canonical(clip, b + 3.0 * direction) - canonical(clip, b);
    CHECK(glm::length(three - 3.0 * one) < 1e-13);
  }
}

TEST_CASE("perspective keeps ratios and angles in planes parallel to the picture") {
  const Projection p = named::one_point();
  const glm::dmat4 clip = clip_of(frame(unit_cube, p));
  for (double depth : {0.0, 0.4, 1.0}) {
    const glm::dvec3 a = canonical(clip, {0.1, 0.2, depth});
    const glm::dvec3 along_x = canonical(clip, {0.7, 0.2, depth}) - a;
    const glm::dvec3 along_y = canonical(clip, {0.1, 0.5, depth}) - a;
    CHECK(std::abs(along_x.y) < 1e-14);
    CHECK(std::abs(along_y.x) < 1e-14);
    CHECK(along_x.x == doctest::Approx(2 * along_y.y));
  }
}

TEST_CASE("one-, two- and three-point perspective have as many finite vanishing points") {
  CHECK(finite_vanishing_points(named::one_point()) == 1);
  CHECK(finite_vanishing_points(named::two_point()) == 2);
  CHECK(finite_vanishing_points(named::three_point()) == 3);
  CHECK(finite_vanishing_points(named::perspective()) == 3);
  for (const Projection& p : parallel_projections()) CHECK(finite_vanishing_points(p) == 0);
}

TEST_CASE("parameters out of range are refused") {
  CHECK_THROWS_AS(named::orthographic(radians(91), 0), Error);
  CHECK_THROWS_AS(named::trimetric(0.1, std::nan("")), Error);
  CHECK_THROWS_AS(named::oblique(0.1, -1), Error);
  CHECK_THROWS_AS(named::oblique(0.1, std::numeric_limits<double>::infinity()), Error);
  CHECK_THROWS_AS(named::military(100), Error);
  CHECK_THROWS_AS(named::perspective(0), Error);
  CHECK_THROWS_AS(named::perspective(pi), Error);
  CHECK_THROWS_AS(named::one_point(0.7, 0, radians(90)), Error);
  CHECK_THROWS_AS(named::two_point(0.7, 0.3, radians(90)), Error);
  CHECK_THROWS_AS(named::three_point(0.7, 0.0, 0.5), Error);
  CHECK_THROWS_AS(named::axonometry({0, 0, pi}, {1, 1, 1}), Error);
  CHECK_THROWS_AS(named::axonometry({0, 1, 2}, {0, 0, 1}), Error);
  CHECK_THROWS_AS(named::axonometry({0, 1, 2}, {1, -1, 1}), Error);
  CHECK_THROWS_AS(named::axonometry({0, std::nan(""), 2}, {1, 1, 1}), Error);
}
