// Occlusion queries: never hide what is seen, and hide most of what is not.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <velum/velum.hpp>

#include "small_scenes.hpp"

using namespace velum;
using velum::test::moved;

namespace {

constexpr int width = 96, height = 72;

/// Walls and solids with gaps between them.
Scene occluders() {
  Scene scene;
  Random random{5};
  for (int i = 0; i < 14; ++i) {
    glm::dmat4 m = moved({random.uniform(-2.0, 2.0), random.uniform(-1.5, 1.5), random.uniform(-1.0, 1.0)});
    m[0].x = random.uniform(0.4, 1.2);
    m[1].y = random.uniform(0.4, 1.2);
    m[2].z = 0.2;
    scene.add(i % 3 == 0 ? shapes::torus(0.6f, 0.25f, 16, 12) : shapes::cube(), m);
  }
  return scene;
}

Camera viewer() {
  return Camera::perspective(Pose::towards({0.3, 0.2, 5.0}, {0.0, 0.0, 0.0}), {VerticalAngle{0.8}}, 0.5,
                             40.0);
}

Aabb random_box(Random& random) {
  const glm::dvec3 centre(random.uniform(-3, 3), random.uniform(-2.5, 2.5), random.uniform(-12, 4));
  const double size = random.below(4) == 0 ? 0.6 : 0.12;
  const glm::dvec3 half(size * random.uniform(0.1, 1.0), size * random.uniform(0.1, 1.0),
                        size * random.uniform(0.1, 1.0));
  return {centre - half, centre + half};
}

/// The box as a mesh, each of its faces two triangles.
Mesh mesh_of(const Aabb& box) {
  Mesh mesh = shapes::cube();
  const Aabb unit = bounds(mesh);
  std::vector<glm::vec3> positions;
  for (const glm::vec3& p : mesh.positions) {
    const glm::dvec3 share = (glm::dvec3(p) - unit.lower) / unit.size();
    positions.emplace_back(box.lower + share * box.size());
  }
  mesh.positions = std::move(positions);
  mesh.normals = {};
  mesh.texture_coordinates = {};
  return mesh;
}

/// Ground truth from the pictures of occluders and box alone: whether the box is seen at some pixel, and
/// whether it is hidden by two pixels or more: also everywhere around its pixels, as far as its nearest
/// depth.
/// The box alone.
struct Alone {
  Image<float> depth{width, height};
  Image<std::uint32_t> triangle_id{width, height};

  Rect bounding_box() const {
    Rect box;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (triangle_id.at(x, y) != no_primitive) box = united(box, {x, y, 1, 1});
      }
    }
    return box;
  }
};

struct Truth {
  bool is_seen = false;
  bool is_deeply_hidden = true;
};
Truth truth_of(const Aabb& box, const Image<float>& behind, Renderer& renderer) {
  Scene scene;
  scene.add(mesh_of(box));
  RenderSettings settings = test::size(width, height);
  settings.threads = 1;
  Alone alone;
  renderer.render_into(scene, viewer(), settings,
                       {.depth = alone.depth.view(), .triangle_id = alone.triangle_id.view()});
  Truth truth;
  float nearest = 1.0f;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) nearest = std::min(nearest, alone.depth.at(x, y));
  }
  const Rect seen = alone.bounding_box();
  if (seen.is_empty()) return {false, false};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool is_there = alone.triangle_id.at(x, y) != no_primitive;
      truth.is_seen = truth.is_seen || (is_there && alone.depth.at(x, y) < behind.at(x, y));
    }
  }
  for (int y = std::max(seen.top - 2, 0); y < std::min(seen.bottom() + 2, height); ++y) {
    for (int x = std::max(seen.left - 2, 0); x < std::min(seen.right() + 2, width); ++x) {
      truth.is_deeply_hidden = truth.is_deeply_hidden && behind.at(x, y) < nearest;
    }
  }
  return truth;
}

void check_boxes(int count) {
  const Scene scene = occluders();
  const OcclusionBuffer buffer(scene, viewer(), width, height);
  Renderer renderer;
  Image<float> behind(width, height);
  renderer.render_into(scene, viewer(), test::size(width, height), {.depth = behind.view()});
  Random random{6};
  int hidden = 0, deeply_hidden = 0, found = 0;
  for (int i = 0; i < count; ++i) {
    const Aabb box = random_box(random);
    const Truth truth = truth_of(box, behind, renderer);
    const bool is_hidden = buffer.is_hidden(box);
    if (is_hidden) CHECK_FALSE(truth.is_seen);
    hidden += is_hidden;
    deeply_hidden += truth.is_deeply_hidden;
    found += truth.is_deeply_hidden && is_hidden;
  }
  CHECK(hidden > count / 10);
  CHECK(deeply_hidden > count / 20);
  CHECK(found >= deeply_hidden * 9 / 10);
}

}  // namespace

TEST_CASE("of 100,000 boxes none that is seen is called hidden, and nine of ten hidden by two pixels are") {
  check_boxes(100000);
}

TEST_CASE("occlusion queries take balls, many boxes at once, and a part of the scene") {
  const Scene scene = occluders();
  const OcclusionBuffer buffer(scene, viewer(), width, height);
  Random random{7};
  std::vector<Aabb> boxes;
  for (int i = 0; i < 300; ++i) boxes.push_back(random_box(random));
  const std::vector<std::uint8_t> answers = buffer.are_hidden(boxes);
  REQUIRE(answers.size() == boxes.size());
  const std::uint32_t one[] = {3};
  const OcclusionBuffer part(scene, viewer(), width, height, one);
  int fewer = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    CHECK((answers[i] != 0) == buffer.is_hidden(boxes[i]));
    if (part.is_hidden(boxes[i])) CHECK(answers[i] != 0);
    fewer += answers[i] != 0 && !part.is_hidden(boxes[i]);
    const Sphere ball{boxes[i].centre(), 0.5 * boxes[i].size().x};
    const Aabb around{ball.centre - ball.radius, ball.centre + ball.radius};
    CHECK(buffer.is_hidden(ball) == buffer.is_hidden(around));
  }
  CHECK(fewer > 0);
  CHECK_THROWS_AS(OcclusionBuffer(scene, viewer(), width, height, std::vector<std::uint32_t>{77}), Error);
}

TEST_CASE("occlusion queries about empty, odd and outlying boxes") {
  const OcclusionBuffer buffer(occluders(), viewer(), width, height);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(buffer.is_hidden(Aabb{}));
  CHECK_FALSE(buffer.is_hidden(Aabb{glm::dvec3(nan), glm::dvec3(nan)}));
  CHECK_FALSE(buffer.is_hidden(Aabb{glm::dvec3(-infinity), glm::dvec3(infinity)}));
  CHECK(buffer.is_hidden(Aabb{glm::dvec3(0, 0, 10), glm::dvec3(1, 1, 11)}));  // behind the viewer
  CHECK_FALSE(buffer.is_hidden(Aabb{glm::dvec3(-0.1, -0.1, 3), glm::dvec3(0.1, 0.1, 6)}));  // around the eye
}
