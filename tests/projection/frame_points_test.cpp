#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "projection/extreme_points.hpp"
#include "projection/frame.hpp"
#include "projection/projection.hpp"
#include "random.hpp"

using namespace velum;

namespace {

/// A ball of points: its box's corners are far from all of them.
std::vector<glm::dvec3> ball(Random& random, int count, const glm::dvec3& centre) {
  std::vector<glm::dvec3> points;
  while (static_cast<int>(points.size()) < count) {
    const glm::dvec3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (glm::dot(p, p) <= 1.0) points.push_back(centre + p);
  }
  return points;
}

/// The largest |x|, |y| of the points on the picture, and their depth range.
struct Extent {
  double x = 0.0, y = 0.0, nearest = 1.0, farthest = 0.0;
};

Extent extent_of(const Camera& camera, const std::vector<glm::dvec3>& points, double aspect) {
  const glm::dmat4 clip_from_world = camera.viewing_transform(aspect).clip_from_world();
  Extent extent;
  for (const glm::dvec3& p : points) {
    const glm::dvec4 c = clip_from_world * glm::dvec4(p, 1.0);
    extent.x = std::max(extent.x, std::fabs(c.x / c.w));
    extent.y = std::max(extent.y, std::fabs(c.y / c.w));
    extent.nearest = std::min(extent.nearest, c.z / c.w);
    extent.farthest = std::max(extent.farthest, c.z / c.w);
  }
  return extent;
}

}  // namespace

TEST_CASE("framing points fills the picture with the margin, under every projection") {
  Random random{31};
  for (const glm::dvec3& centre : {glm::dvec3(0.0), glm::dvec3(1e4, -2e4, 3e4)}) {
    const std::vector<glm::dvec3> points = ball(random, 500, centre);
    for (const ProjectionEntry& entry : projection_catalogue()) {
      FrameOptions options;
      options.aspect = 1.5;
      options.margin = 0.1;
      const Camera camera = frame(points, parse_projection(entry.name), options);
      const Extent extent = extent_of(camera, points, options.aspect);
      CAPTURE(entry.name);
      CHECK(std::max(extent.x, extent.y) == doctest::Approx(0.8).epsilon(1e-6));
      CHECK(extent.nearest >= 0.0);
      CHECK(extent.nearest < 0.05);
      CHECK(extent.farthest <= 1.0);
      CHECK(extent.farthest > 0.95);
    }
  }
}

TEST_CASE("points in a box's corners are framed as the box; no points as an empty box") {
  Aabb box;
  box.include(glm::dvec3(-1, -2, -3));
  box.include(glm::dvec3(4, 5, 6));
  const auto corners = box.corners();
  const Camera of_points = frame(corners, projection::isometric());
  const Camera of_box = frame(box, projection::isometric());
  CHECK(glm::distance(of_points.pose().position, of_box.pose().position) < 1e-9);
  CHECK(std::get<ParallelWindow>(of_points.lens()).height ==
        doctest::Approx(std::get<ParallelWindow>(of_box.lens()).height));
  const std::vector<glm::dvec3> none{glm::dvec3(std::numeric_limits<double>::quiet_NaN())};
  CHECK(frame(none, projection::perspective()).pose().position ==
        frame(Aabb{}, projection::perspective()).pose().position);
}

TEST_CASE("extreme points hold all others, seen along the camera's axes") {
  Random random{32};
  const std::vector<glm::dvec3> points = ball(random, 2000, glm::dvec3(0.0));
  const CameraAxes axes = camera_axes(glm::dvec3(-1, -2, -3), glm::dvec3(0, 1, 0));
  const std::vector<glm::dvec3> extreme = extreme_points(points, axes, glm::dvec3(0.0));
  CHECK(extreme.size() < 200);
  const auto farthest = [&](const std::vector<glm::dvec3>& of, const glm::dvec3& direction) {
    double value = -1e300;
    for (const glm::dvec3& p : of) value = std::max(value, glm::dot(axes.camera_from_world(p), direction));
    return value;
  };
  for (int i = 0; i < 200; ++i) {
    const double along = random.uniform(-1, 1), depth = random.uniform(-1, 1);
    for (const glm::dvec3& direction : {glm::dvec3(along, 0, depth), glm::dvec3(0, along, depth)}) {
      CHECK(farthest(extreme, direction) == doctest::Approx(farthest(points, direction)).epsilon(1e-12));
    }
  }
}
