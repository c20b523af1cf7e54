// Projections measured in the finished picture: what each name promises, to half a pixel.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <vector>
#include <velum/velum.hpp>

#include "../random.hpp"

using namespace velum;

namespace {

constexpr int side = 480;

/// Every visible pixel's place on the surface, and the direction it faces.
struct Measured {
  Picture picture;
  Image<glm::dvec3> position{side, side};
  double pixels_per_unit = 0.0;  ///< parallel projections

  bool is_seen(int x, int y) const { return picture.triangle_id.at(x, y) != 0xFFFFFFFFu; }
  bool on_one_plane(const glm::ivec2& a, const glm::ivec2& b) const {
    const glm::vec3 normal = picture.normal.at(a.x, a.y);
    const glm::dvec3 way = position.at(b.x, b.y) - position.at(a.x, a.y);
    return normal == picture.normal.at(b.x, b.y) && std::abs(glm::dot(way, glm::dvec3(normal))) < 1e-6;
  }
};

Measured measure(Mesh mesh, const Projection& projection) {
  Scene scene;
  scene.add(std::move(mesh));
  FrameOptions framing;
  framing.margin = 0.1;
  const Camera camera = frame(scene.bounds(), projection, framing);
  Measured measured;
  RenderSettings settings;
  settings.width = side;
  settings.height = side;
  settings.shader = [&measured](const SurfacePoint& point) {
    measured.position.at(point.x, point.y) = point.position;
    return glm::vec4(1.0f);
  };
  measured.picture = render(scene, camera, settings);
  if (const auto* window = std::get_if<ParallelWindow>(&camera.lens())) {
    measured.pixels_per_unit = side / window->height;
  }
  return measured;
}

std::vector<glm::ivec2> seen_pixels(const Measured& measured) {
  std::vector<glm::ivec2> pixels;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (measured.is_seen(x, y)) pixels.emplace_back(x, y);
    }
  }
  return pixels;
}

struct Promise {
  const char* projection;
  std::array<double, 3> degrees;  ///< of x, y, z on the picture, counter-clockwise from the right
  std::array<double, 3> scales;
};

/// From PROJECTIONS' tables, with more digits where they are roots.
const Promise promises[] = {
    {"front", {0, 90, 0}, {1, 1, 0}},
    {"back", {180, 90, 0}, {1, 1, 0}},
    {"left", {0, 90, 0}, {0, 1, 1}},
    {"right", {0, 90, 180}, {0, 1, 1}},
    {"top", {0, 0, 270}, {1, 0, 1}},
    {"bottom", {0, 0, 90}, {1, 0, 1}},
    {"isometric", {-30, 90, 210}, {0.8164965809, 0.8164965809, 0.8164965809}},
    {"dimetric", {-7.180755781, 90, 221.4096221}, {0.9428090416, 0.9428090416, 0.4714045208}},
    {"dimetric-2to1", {-26.56505118, 90, 206.5650512}, {0.7905694150, 0.8660254038, 0.7905694150}},
    {"cavalier", {0, 90, 225}, {1, 1, 1}},
    {"cabinet", {0, 90, 225}, {1, 1, 0.5}},
    {"cabinet:angle=30", {0, 90, 210}, {1, 1, 0.5}},
    {"natural-oblique", {0, 90, 225}, {1, 1, 0.6666666667}},
    {"oblique:angle=60,scale=0.8", {0, 90, 240}, {1, 1, 0.8}},
    {"military", {-45, 90, 225}, {1, 1, 1}},
    {"military:turn=30,scale=0.6666666667", {-30, 90, 240}, {1, 0.6666666667, 1}},
};

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// A face of the cube as it should be drawn: a parallelogram, in pixels from the middle of the picture, y up.
struct DrawnFace {
  glm::dvec2 centre, first, second;

  bool is_seen_edge_on() const { return std::abs(cross(first, second)) < 1.0; }
  /// The distance of a point from the nearest edge, in pixels; negative outside (there it is a lower bound).
  double depth_inside(const glm::dvec2& point) const {
    const double area = std::abs(cross(first, second));
    const glm::dvec2 from = point - centre;
    const double to_second = 0.5 * area - std::abs(cross(from, second));
    const double to_first = 0.5 * area - std::abs(cross(from, first));
    return std::min(to_second / glm::length(second), to_first / glm::length(first));
  }
};

std::array<DrawnFace, 3> promised_faces(const Promise& promise, double pixels_per_unit) {
  std::array<glm::dvec2, 3> edge;
  for (std::size_t i = 0; i < 3; ++i) {
    const double angle = radians(promise.degrees[i]);
    edge[i] = pixels_per_unit * promise.scales[i] * glm::dvec2(std::cos(angle), std::sin(angle));
  }
  std::array<DrawnFace, 3> faces;
  for (std::size_t i = 0; i < 3; ++i) faces[i] = {0.5 * edge[i], edge[(i + 1) % 3], edge[(i + 2) % 3]};
  return faces;
}

/// Pixels that show another face than they should, more than `tolerance` pixels away from any edge.
int wrong_pixels(const Measured& measured, const std::array<DrawnFace, 3>& faces, double tolerance) {
  int wrong = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 point{x + 0.5 - side / 2, side / 2 - (y + 0.5)};
      bool is_outside_all = true;
      for (int i = 0; i < 3; ++i) {
        const DrawnFace& face = faces[static_cast<std::size_t>(i)];
        if (face.is_seen_edge_on()) continue;
        const double depth = face.depth_inside(point);
        is_outside_all = is_outside_all && depth < -tolerance;
        const float towards = measured.picture.normal.at(x, y)[i];
        if (depth > tolerance && std::abs(towards) < 0.99f) ++wrong;
      }
      if (is_outside_all && measured.is_seen(x, y)) ++wrong;
    }
  }
  return wrong;
}

/// The first and last column in which a front face (z) meets a side (x): equal where that edge is upright.
std::pair<int, int> columns_of_upright_edge(const Measured& measured) {
  std::pair<int, int> columns{side, -1};
  for (int y = 0; y < side; ++y) {
    for (int x = 1; x < side; ++x) {
      const bool meets =
          measured.picture.normal.at(x - 1, y).z > 0.9f && measured.picture.normal.at(x, y).x > 0.9f;
      if (meets) columns = {std::min(columns.first, x), std::max(columns.second, x)};
    }
  }
  return columns;
}

}  // namespace

TEST_CASE("a cube's edges have the promised angles and lengths in the picture, to half a pixel") {
  for (const Promise& promise : promises) {
    const std::string name = promise.projection;
    CAPTURE(name);
    const Measured measured = measure(shapes::cube(), parse_projection(name));
    CHECK(wrong_pixels(measured, promised_faces(promise, measured.pixels_per_unit), 0.1) == 0);
  }
}

TEST_CASE(
    "the measurement sees an edge that is two pixels too long, one that is turned, and a mirrored picture") {
  const Measured measured = measure(shapes::cube(), projection::cabinet());
  const double scale = measured.pixels_per_unit;
  const auto wrong = [&](const Promise& promise) {
    return wrong_pixels(measured, promised_faces(promise, scale), 0.1);
  };
  CHECK(wrong({"", {0, 90, 225}, {1, 1, 0.5 + 2.0 / scale}}) > 0);
  CHECK(wrong({"", {0, 90, 226}, {1, 1, 0.5}}) > 0);
  CHECK(wrong({"", {180, 90, 315}, {1, 1, 0.5}}) > 0);
}

TEST_CASE("one-point perspective shows the front as a true square, two-point keeps verticals vertical") {
  const Measured one = measure(shapes::cube(), projection::one_point());
  glm::ivec2 first(side);
  glm::ivec2 last(-1);
  int count = 0;
  for (const glm::ivec2& pixel : seen_pixels(one)) {
    if (one.picture.normal.at(pixel.x, pixel.y).z < 0.9f) continue;
    first = glm::min(first, pixel);
    last = glm::max(last, pixel);
    ++count;
  }
  const glm::ivec2 size = last - first + 1;
  CHECK(count == size.x * size.y);
  CHECK(std::abs(size.x - size.y) <= 1);

  const auto two = columns_of_upright_edge(measure(shapes::cube(), projection::two_point()));
  CHECK(two.first == two.second);
  const auto three = columns_of_upright_edge(measure(shapes::cube(), projection::three_point()));
  CHECK(three.second - three.first > 5);
}

TEST_CASE("no projection mirrors: three points of a face turn alike on the surface and in the picture") {
  Random random{11};
  for (const ProjectionEntry& entry : projection_catalogue()) {
    CAPTURE(entry.name);
    const Measured measured = measure(shapes::letter_f(), parse_projection(entry.name));
    const std::vector<glm::ivec2> seen = seen_pixels(measured);
    int compared = 0;
    int mirrored = 0;
    for (int attempt = 0; attempt < 100000 && compared < 200; ++attempt) {
      const auto any = [&] {
        return seen[static_cast<std::size_t>(random.below(static_cast<int>(seen.size())))];
      };
      const glm::ivec2 a = any();
      const glm::ivec2 b = any();
      const glm::ivec2 c = any();
      const int turn_in_picture = -((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));  // y points down
      if (!measured.on_one_plane(a, b) || !measured.on_one_plane(a, c) || std::abs(turn_in_picture) < 100)
        continue;
      const glm::dvec3 from = measured.position.at(a.x, a.y);
      const glm::dvec3 normal(measured.picture.normal.at(a.x, a.y));
      const double turn = glm::dot(
          glm::cross(measured.position.at(b.x, b.y) - from, measured.position.at(c.x, c.y) - from), normal);
      ++compared;
      if ((turn > 0.0) != (turn_in_picture > 0)) ++mirrored;
    }
    CHECK(compared == 200);
    CHECK(mirrored == 0);
  }
}

TEST_CASE("the letter F reads as an F: in the front view its arms point to the right, the long one on top") {
  const Measured measured = measure(shapes::letter_f(), projection::front());
  const Rect box = measured.picture.bounding_box();
  const auto is_full = [&measured, &box](double across, double down) {
    return measured.is_seen(box.left + static_cast<int>(across * box.width),
                            box.top + static_cast<int>(down * box.height));
  };
  for (const double down : {0.02, 0.3, 0.5, 0.7, 0.98}) CHECK(is_full(0.02, down));
  CHECK(is_full(0.98, 0.02));
  for (const double down : {0.3, 0.5, 0.7, 0.98}) CHECK_FALSE(is_full(0.98, down));
  CHECK_FALSE(is_full(0.5, 0.98));
}
