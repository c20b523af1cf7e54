#include "pipeline/clip_trace.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <limits>

#include "random.hpp"

using namespace velum;

namespace {

glm::dvec4 random_vertex(Random& random) {
  // Whole and half coordinates now and then, so that vertices and edges lie exactly on planes.
  const auto number = [&random](double reach) {
    const double v = random.uniform(-reach, reach);
    return random.below(4) == 0 ? static_cast<double>(static_cast<int>(2.0 * v)) / 2.0 : v;
  };
  const double w = random.below(2) == 0 ? 2.0 : number(1.5);
  return {number(2.0), number(2.0), number(1.5), w};
}

bool equals(const ClippedPolygon& polygon, const ClipTrace& trace) {
  if (static_cast<std::size_t>(polygon.count) != trace.result.size()) return false;
  for (std::size_t i = 0; i < trace.result.size(); ++i) {
    if (trace.vertices[static_cast<std::size_t>(trace.result[i])].position != polygon.vertices[i])
      return false;
  }
  return true;
}

Outcode cutting_planes(const ClipTrace& trace) {
  unsigned planes = 0;
  for (const ClipStep& step : trace.steps) {
    if (step.cuts) planes |= 1u << static_cast<unsigned>(step.plane);
  }
  return static_cast<Outcode>(planes);
}

/// Whether a cut vertex lies on its plane, between its ends, at the parameter that is told.
bool is_right(const TracedVertex& v, const ClipTrace& trace) {
  const auto at = [&trace](int number) { return trace.vertices[static_cast<std::size_t>(number)].position; };
  const ClipPlaneRow& row = clip_planes[static_cast<std::size_t>(v.plane)];
  const glm::dvec4 expected = at(v.inside) + (at(v.outside) - at(v.inside)) * v.t;
  const glm::dvec4 error = glm::abs(expected - v.position);
  return signed_value(row, v.position) == 0.0 && v.d_in > 0.0 && v.d_out < 0.0 &&
         v.t == v.d_in / (v.d_in - v.d_out) && std::max({error.x, error.y, error.z, error.w}) < 1e-12;
}

}  // namespace

TEST_CASE("the trace ends with clip_triangle's polygon, and each new vertex is told rightly") {
  Random random{41};
  int verdicts[4] = {};
  bool same = true;
  bool right = true;
  for (int i = 0; i < 3000; ++i) {
    const glm::dvec4 a = random_vertex(random), b = random_vertex(random), c = random_vertex(random);
    const ClippedPolygon polygon = clip_triangle(a, b, c);
    const ClipTrace trace = trace_clipping(a, b, c);
    same = same && equals(polygon, trace);
    if (trace.verdict == ClipVerdict::clipped) same = same && polygon.cut_by == cutting_planes(trace);
    for (const TracedVertex& vertex : trace.vertices)
      right = right && (!vertex.is_cut() || is_right(vertex, trace));
    ++verdicts[static_cast<int>(trace.verdict)];
  }
  CHECK(same);
  CHECK(right);
  for (const int count : verdicts) CHECK(count > 10);
}

TEST_CASE("a triangle with one corner to the right: two cuts whose parameters can be seen") {
  const ClipTrace trace = trace_clipping({0, 0, 0.5, 1}, {3, 0, 0.5, 1}, {0, 1, 0.5, 1});
  CHECK(trace.verdict == ClipVerdict::clipped);
  CHECK(trace.some_outside == 8);
  CHECK(trace.all_outside == 0);
  REQUIRE(trace.vertices.size() == 5);
  const ClipStep& right = trace.steps[3];
  CHECK(right.plane == ClipPlane::right);
  CHECK(right.cuts);
  CHECK(right.removed == std::vector<int>{1});
  CHECK(right.made == std::vector<int>{3, 4});
  CHECK(right.polygon == std::vector<int>{0, 3, 4, 2});
  CHECK(trace.vertices[3].inside == 0);
  CHECK(trace.vertices[3].outside == 1);
  CHECK(trace.vertices[3].t == doctest::Approx(1.0 / 3.0));
  CHECK(trace.vertices[4].inside == 2);
  CHECK(trace.vertices[4].position.y == doctest::Approx(2.0 / 3.0));
  for (const int i : {0, 1, 2, 4, 5}) CHECK_FALSE(trace.steps[static_cast<std::size_t>(i)].cuts);
  CHECK(trace.result == right.polygon);
}

TEST_CASE("trivial cases end at once") {
  const ClipTrace inside = trace_clipping({0, 0, 0.5, 1}, {0.5, 0, 0.5, 1}, {0, 1, 0.5, 1});
  CHECK(inside.verdict == ClipVerdict::accepted);
  CHECK(inside.result == std::vector<int>{0, 1, 2});
  const ClipTrace outside = trace_clipping({2, 0, 0.5, 1}, {3, 0, 0.5, 1}, {2, 1, 0.5, 1});
  CHECK(outside.verdict == ClipVerdict::rejected);
  CHECK(outside.all_outside == 8);
  CHECK(outside.result.empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(trace_clipping({nan, 0, 0, 1}, {0, 0, 0, 1}, {0, 1, 0, 1}).verdict == ClipVerdict::rejected);
}
