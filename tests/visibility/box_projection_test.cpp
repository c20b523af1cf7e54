// Bounds of boxes on the picture, and normal cones, against what is really drawn.
#include "visibility/box_projection.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <velum/velum.hpp>

#include "pipeline/stages.hpp"
#include "random.hpp"
#include "visibility/cone_culling.hpp"
#include "visibility/zbuffer.hpp"

using namespace velum;

namespace {

constexpr Viewport viewport{64, 48};

Camera random_camera(Random& random, int kind) {
  const auto vector = [&](double reach) {
    return glm::dvec3(random.uniform(-reach, reach), random.uniform(-reach, reach),
                      random.uniform(-reach, reach));
  };
  const Pose pose = Pose::towards(vector(3.0), vector(0.7));
  if (kind == 0) return Camera::perspective(pose, {VerticalAngle{random.uniform(0.3, 2.0)}}, 0.3, 9.0);
  if (kind == 1) return Camera::perspective(pose, {VerticalAngle{1.0}, {0.3, -0.2}}, 0.01, 1000.0);
  return Camera::parallel(pose, {3.0, {0.4, -0.3}, 2.0}, kind == 2 ? 0.5 : -4.0, 8.0);
}

glm::dmat4 random_placement(Random& random) {
  glm::dmat4 m(1.0);
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) m[i][k] += random.uniform(-0.4, 0.4);
    m[3][i] = random.uniform(-1.0, 1.0);
  }
  if (random.below(2) == 0) m[0] = -m[0];
  return m;
}

/// A few triangles in a box of some size somewhere.
std::vector<glm::vec3> random_positions(Random& random) {
  const double size = random.below(3) == 0 ? 2.0 : 0.2;
  const glm::dvec3 at(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  std::vector<glm::vec3> positions;
  for (int i = 0; i < 12; ++i) {
    positions.emplace_back(
        at + size * glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
  }
  return positions;
}

struct Drawn {
  VisibilityBuffer buffer{viewport.width, viewport.height};
  int triangles = 0;
};

Drawn draw(const std::vector<glm::vec3>& positions, const glm::dmat4& clip_from_object) {
  ClipVertices vertices;
  transform_vertices(positions, clip_from_object, vertices);
  std::vector<ScreenTriangle> screen;
  Counters counters;
  for (std::uint32_t i = 0; i + 2 < positions.size(); i += 3) {
    const AssembledTriangle triangle = assemble(vertices, {i, i + 1, i + 2}, false, Cull::none, {}, counters);
    if (triangle.fate == TriangleFate::accepted || triangle.fate == TriangleFate::to_clip) {
      set_up(triangle, i, viewport, counters, screen);
    }
  }
  Drawn drawn;
  drawn.triangles = static_cast<int>(screen.size());
  rasterize_zbuffer(screen, {drawn.buffer, {0, 0, viewport.width, viewport.height}});
  return drawn;
}

Aabb box_of(const std::vector<glm::vec3>& positions) {
  Aabb box;
  for (const glm::vec3& position : positions) box.include(glm::dvec3(position));
  return box;
}

/// Fragments outside the bounds, with the depth bound divided by `planted`.
int fragments_beyond(const VisibilityBuffer& buffer, const BoxOnPicture& bounds, float planted) {
  int beyond = 0;
  for (int y = 0; y < buffer.height(); ++y) {
    for (int x = 0; x < buffer.width(); ++x) {
      if (buffer.primitive.at(x, y) == no_primitive) continue;
      beyond += bounds.is_outside || !bounds.pixels.contains(x, y) ||
                buffer.reversed_depth.at(x, y) > bounds.nearest / planted;
    }
  }
  return beyond;
}

}  // namespace

TEST_CASE("nothing of a box is drawn outside its bounds on the picture, and a planted bound is caught") {
  Random random{1};
  int outside = 0, bounded = 0, beyond_planted = 0;
  for (int i = 0; i < 4000; ++i) {
    const Camera camera = random_camera(random, i % 4);
    const glm::dmat4 matrix =
        camera.viewing_transform(64.0 / 48.0).clip_from_object(random_placement(random));
    const std::vector<glm::vec3> positions = random_positions(random);
    const Aabb box = box_of(positions);
    Aabb within = box;
    within.include(glm::dvec3(2.0));
    const BoxOnPicture bounds = BoxProjection(matrix, viewport, within)(box);
    const Drawn drawn = draw(positions, matrix);
    CHECK(fragments_beyond(drawn.buffer, bounds, 1.0f) == 0);
    CHECK((!bounds.is_outside || drawn.triangles == 0));
    outside += bounds.is_outside;
    bounded += !bounds.is_outside && bounds.nearest < 1.0f;
    beyond_planted += fragments_beyond(drawn.buffer, bounds, 1.01f) > 0;
  }
  CHECK(outside > 200);
  CHECK(bounded > 500);
  CHECK(beyond_planted > 50);
}

TEST_CASE("a box's bounds are tight: around its corners, to a pixel") {
  const Camera camera = Camera::perspective({}, {VerticalAngle{1.0}}, 1.0, 100.0);
  const glm::dmat4 matrix = camera.viewing_transform(64.0 / 48.0).clip_from_world();
  const Aabb box{{-1.0, -0.5, -11.0}, {0.5, 1.0, -10.0}};
  const BoxOnPicture bounds = BoxProjection(matrix, viewport, box)(box);
  double left = 1e9, right = -1e9, nearest = 0.0;
  for (const glm::dvec3& corner : box.corners()) {
    const glm::dvec4 clip = matrix * glm::dvec4(corner, 1.0);
    const double x = viewport.pixel_from_ndc(clip.x / clip.w, 0.0).x;
    left = std::min(left, x);
    right = std::max(right, x);
    nearest = std::max(nearest, 1.0 - clip.z / clip.w);
  }
  CHECK((bounds.pixels.left - left > -0.5 && bounds.pixels.left - left < 0.6));
  CHECK((bounds.pixels.right() - right < 0.5 && bounds.pixels.right() - right > -0.6));
  CHECK(bounds.nearest == doctest::Approx(nearest).epsilon(1e-6));
}

TEST_CASE("boxes at the eye, and boxes that are no numbers, have no bounds") {
  const Camera camera = Camera::perspective({}, {VerticalAngle{1.0}}, 1.0, 100.0);
  const glm::dmat4 matrix = camera.viewing_transform(64.0 / 48.0).clip_from_world();
  const Aabb infinite{glm::dvec3(-std::numeric_limits<double>::infinity()),
                      glm::dvec3(std::numeric_limits<double>::infinity())};
  const Aabb around_eye{glm::dvec3(-1.0), glm::dvec3(1.0)};
  const Aabb huge{glm::dvec3(-1e308), glm::dvec3(1e308)};
  for (const Aabb& box : {infinite, around_eye, huge}) {
    const BoxOnPicture bounds = BoxProjection(matrix * 1e200, viewport, box)(box);
    CHECK_FALSE(bounds.is_outside);
    CHECK(bounds.nearest >= 1.0f);
    CHECK((bounds.pixels == Rect{0, 0, viewport.width, viewport.height}));
  }
}

TEST_CASE("a normal cone tells the sign of all determinants, or nothing") {
  Random random{2};
  int told = 0, guessed_right = 0, guesses = 0;
  for (int i = 0; i < 6000; ++i) {
    const Camera camera = random_camera(random, i % 4);
    const glm::dmat4 matrix =
        camera.viewing_transform(64.0 / 48.0).clip_from_object(random_placement(random));
    // Triangles about one plane.
    const auto coordinate = [&](double reach) { return static_cast<float>(random.uniform(-reach, reach)); };
    std::vector<glm::vec3> positions;
    const float roughness = static_cast<float>(0.05 * (i % 10));
    for (int k = 0; k < 4; ++k) {
      const glm::vec3 at(coordinate(0.3), coordinate(0.3), coordinate(roughness));
      positions.push_back(at);
      positions.push_back(at + glm::vec3(0.1f, coordinate(0.02), coordinate(roughness)));
      positions.push_back(at + glm::vec3(coordinate(0.02), 0.1f, coordinate(roughness)));
    }
    std::vector<std::uint32_t> indices(positions.size());
    for (std::uint32_t k = 0; k < indices.size(); ++k) indices[k] = k;
    const NormalCone cone = normal_cone(positions, indices);
    const Aabb box = box_of(positions);
    const BoxProjection projection(matrix, viewport, box);
    const ConeCulling culling(projection);
    ClipVertices vertices;
    transform_vertices(positions, matrix, vertices);
    int positive = 0, negative = 0;
    for (std::size_t k = 0; k < positions.size(); k += 3) {
      const double determinant = homogeneous_determinant(vertices.positions[k], vertices.positions[k + 1],
                                                         vertices.positions[k + 2]);
      (determinant > 0.0 ? positive : negative) += 1;
    }
    if (culling.all_have_sign(cone, box, 1.0)) CHECK(negative == 0);
    if (culling.all_have_sign(cone, box, -1.0)) CHECK(positive == 0);
    told += culling.all_have_sign(cone, box, 1.0) || culling.all_have_sign(cone, box, -1.0);
    if (!cone.is_valid) continue;
    ++guesses;
    guessed_right += culling.has_sign(cone, box, positive > negative ? 1.0 : -1.0);
  }
  CHECK(told > 1000);
  CHECK(guessed_right > guesses * 8 / 10);
}
