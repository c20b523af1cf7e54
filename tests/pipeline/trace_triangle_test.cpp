#include "pipeline/trace_triangle.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <glm/common.hpp>
#include <limits>

#include "small_scenes.hpp"

using namespace velum;
using namespace velum::test;

namespace {

bool is_close(const glm::dvec4& a, const glm::dvec4& b) {
  const glm::dvec4 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z, d.w}) <= 1e-12 * (1.0 + std::abs(a.w));
}

Scene one_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  Mesh mesh;
  mesh.positions = {a, b, c};
  mesh.triangles = {glm::uvec3(0, 1, 2)};
  Scene scene;
  scene.add(mesh);
  return scene;
}

/// Looks along -z from the origin; the window reaches from -d to d at distance d; near 1, far 5.
Camera simple_camera() {
  PerspectiveLens lens;
  lens.opening = VerticalAngle{radians(90.0)};
  return Camera::perspective({}, lens, 1.0, 5.0);
}

}  // namespace

TEST_CASE("the images after the stages end where the pipeline's product does, for every triangle") {
  const Scene scene = meeting_solids();
  const RenderSettings settings = size(40, 30);
  for (const char* name : {"perspective", "cabinet", "military", "two-point"}) {
    const Camera camera = camera_of(scene, name, settings);
    const std::size_t stages = camera.viewing_transform(40.0 / 30.0).stages().size();
    bool right = true;
    for (std::uint32_t id = 0; id < scene.primitive_count(); ++id) {
      const TriangleTrace trace = trace_triangle(scene, camera, settings, id);
      for (const VertexTrace& vertex : trace.vertices) {
        right = right && vertex.images.size() == stages + 1 && is_close(vertex.images.back(), vertex.clip) &&
                vertex.code == outcode(vertex.clip);
      }
      right = right && trace.primitive == id && trace.place == scene.place(id);
      right = right && (trace.pieces.empty() || trace.pieces.size() + 2 == trace.polygon.size());
    }
    CAPTURE(name);
    CHECK(right);
  }
}

TEST_CASE("the numbers of a triangle that can be followed by hand") {
  const Scene scene = one_triangle({-1, -1, -2}, {1, -1, -2}, {0, 2, -4});
  const TriangleTrace trace = trace_triangle(scene, simple_camera(), size(100, 100), 0);
  CHECK(trace.assembled.fate == TriangleFate::accepted);
  CHECK(trace.assembled.facing == Facing::front);
  CHECK_FALSE(trace.mirrored);
  REQUIRE(trace.polygon.size() == 3);
  // At distance 2 the window reaches from -2 to 2: x = ±1/2, y = -1/2. At distance 4: y = 1/2.
  CHECK(trace.polygon[0].ndc.x == doctest::Approx(-0.5));
  CHECK(trace.polygon[0].pixel.x == doctest::Approx(25.0));
  CHECK(trace.polygon[0].pixel.y == doctest::Approx(75.0));
  CHECK(trace.polygon[0].snapped == SnappedVertex{6400, 19200});
  CHECK(trace.polygon[2].snapped == SnappedVertex{12800, 6400});
  // z = far/(far-near)·(1 - near/d): 5/4·1/2 and 5/4·3/4.
  CHECK(trace.polygon[0].ndc.z == doctest::Approx(0.625));
  CHECK(trace.polygon[2].ndc.z == doctest::Approx(0.9375));
  REQUIRE(trace.pieces.size() == 1);
  // The pieces are the fan over the polygon.
  CHECK(trace.pieces[0].vertices[1] == trace.polygon[1].snapped);
}

TEST_CASE("cut, rejected, culled and broken triangles are told as what they are") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  RenderSettings settings = size(100, 100);
  const auto trace = [&settings](const glm::vec3& c) {
    return trace_triangle(one_triangle({-1, -1, -2}, {1, -1, -2}, c), simple_camera(), settings, 0);
  };
  const TriangleTrace cut = trace({0, 2, 1});  // the third corner lies behind the eye
  CHECK(cut.assembled.fate == TriangleFate::to_clip);
  CHECK((cut.cut_by & 1) == 1);
  CHECK_FALSE(cut.vertices[2].is_in_front());
  CHECK(cut.polygon.size() >= 4);
  CHECK(cut.pieces.size() == cut.polygon.size() - 2);
  for (const PlacedPoint& point : cut.polygon) CHECK(point.is_snapped);
  settings.clip = ClipPolicy::exact;
  for (const PlacedPoint& point : trace({0, 2, 1}).polygon) CHECK(outcode(point.clip) == 0);
  CHECK(trace({0, nan, -2}).assembled.fate == TriangleFate::not_finite);
  CHECK(trace({0, nan, -2}).polygon.empty());
  settings.cull = Cull::front;
  CHECK(trace({0, 2, -4}).assembled.fate == TriangleFate::culled);
  const Scene outside = one_triangle({5, 0, -2}, {6, 0, -2}, {5, 1, -2});
  const TriangleTrace rejected = trace_triangle(outside, simple_camera(), size(100, 100), 0);
  CHECK(rejected.assembled.fate == TriangleFate::rejected);
  CHECK(rejected.assembled.all_outside == 8);  // right
  CHECK(rejected.pieces.empty());
}

TEST_CASE(
    "a triangle that leaves the picture sideways is cut by the view volume, and left whole by the guard") {
  const Scene scene = one_triangle({-1, -1, -2}, {9, -1, -2}, {0, 1, -2});
  RenderSettings settings = size(100, 100);
  const TriangleTrace guarded = trace_triangle(scene, simple_camera(), settings, 0);
  CHECK(guarded.assembled.fate == TriangleFate::accepted);
  CHECK(guarded.cut_by == 0);
  CHECK(guarded.pieces.size() == 1);
  CHECK(guarded.polygon[1].is_snapped);
  CHECK(guarded.polygon[1].snapped == SnappedVertex{275 * subpixels, 75 * subpixels});
  settings.clip = ClipPolicy::exact;
  const TriangleTrace exact = trace_triangle(scene, simple_camera(), settings, 0);
  CHECK(exact.assembled.fate == TriangleFate::to_clip);
  CHECK(exact.cut_by == 8);  // right
  CHECK(exact.pieces.size() == 2);
  CHECK(std::memcmp(&exact.pieces[0].depth, &guarded.pieces[0].depth, sizeof(DepthPlane)) == 0);
}
