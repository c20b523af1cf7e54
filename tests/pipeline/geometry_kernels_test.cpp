#include "pipeline/geometry_kernels.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <limits>
#include <vector>

#include "pipeline/primitive_batch.hpp"
#include "pipeline/stages.hpp"
#include "random.hpp"
#include "visibility/tile_bins.hpp"

using namespace velum;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Without what pads a triangle to a cache line.
constexpr std::size_t large_bytes = offsetof(RasterTriangle, primitive) + sizeof(std::uint32_t);
constexpr std::size_t small_bytes = offsetof(SmallTriangle, primitive) + sizeof(std::uint32_t);

template <typename T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// What a kernel wrote, per vertex.
struct Transformed {
  std::vector<glm::dvec4> clip;
  std::vector<Outcode> outcodes;
  std::vector<PlacedVertex> placed;
  std::vector<float> nearness;
};

Transformed transformed(const std::vector<glm::vec3>& positions, const glm::dmat4& matrix,
                        const Viewport& viewport, Isa isa) {
  const std::size_t n = positions.size();
  Transformed out{std::vector<glm::dvec4>(n), std::vector<Outcode>(n), std::vector<PlacedVertex>(n),
                  std::vector<float>(n)};
  transform_kernel(isa)({&positions[0].x, n, glm::value_ptr(matrix), viewport.width, viewport.height,
                         &out.clip[0].x, out.outcodes.data(), out.placed.data(), out.nearness.data()});
  return out;
}

std::vector<glm::vec3> random_positions(Random& random, int count, double size) {
  std::vector<glm::vec3> positions;
  for (int i = 0; i < count; ++i) {
    const auto coordinate = [&] {
      const int kind = random.below(60);
      if (kind == 0) return std::numeric_limits<float>::quiet_NaN();
      if (kind == 1) return std::numeric_limits<float>::infinity();
      if (kind == 2) return -std::numeric_limits<float>::max();
      if (kind < 12) return static_cast<float>(random.below(5) - 2);
      return static_cast<float>(random.uniform(-size, size));
    };
    positions.emplace_back(coordinate(), coordinate(), coordinate());
  }
  return positions;
}

glm::dmat4 random_matrix(Random& random) {
  glm::dmat4 matrix;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) matrix[column][row] = random.uniform(-1.0, 1.0);
  }
  matrix[3].w = random.uniform(0.5, 4.0);
  return matrix;
}

void check_vertices(const std::vector<glm::vec3>& positions, const glm::dmat4& matrix,
                    const Viewport& viewport, const Transformed& actual) {
  ClipVertices expected;
  transform_vertices(positions, matrix, expected);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    CAPTURE(i);
    for (int k = 0; k < 4; ++k) {
      const double wanted = expected.positions[i][k], got = actual.clip[i][k];
      const bool is_same = same_bits(wanted, got) || (wanted != wanted && got != got);
      CHECK(is_same);
    }
    CHECK(actual.outcodes[i] == expected.outcodes[i]);
    const bool has_place = expected.outcodes[i] == 0 && expected.positions[i].w > 0.0;
    CHECK((actual.placed[i].x != not_snapped) == has_place);
    if (!has_place) {
      const glm::dvec4& v = expected.positions[i];
      const double sum = (v.x + v.y) + (v.z + v.w);
      CHECK(actual.placed[i].y == (sum - sum == 0.0 ? expected.outcodes[i] : 0));
      continue;
    }
    const SnappedVertex snapped = snap(expected.positions[i], viewport);
    CHECK(actual.placed[i].x == snapped.x);
    CHECK(actual.placed[i].y == snapped.y);
  }
}

/// The plain path over the triangles that need no clipping.
struct Expected {
  ScreenPrimitives primitives;
  std::vector<std::uint32_t> slow;
  Counters counters;
};

struct Case {
  const std::vector<glm::vec3>& positions;
  const glm::dmat4& matrix;
  const ClipVertices& vertices;
  const std::vector<PlacedVertex>& placed;
  const std::vector<float>& nearness;
  const std::vector<glm::uvec3>& triangles;
  Viewport viewport;
  Rect target;
  bool mirrored;
  Cull cull;
};

Expected by_the_plain_path(const Case& c) {
  Expected expected;
  std::vector<ScreenTriangle> pieces;
  for (std::uint32_t i = 0; i < c.triangles.size(); ++i) {
    const glm::uvec3& t = c.triangles[i];
    const PlacedVertex placed[3] = {c.placed[t.x], c.placed[t.y], c.placed[t.z]};
    const auto has_place = [](const PlacedVertex& vertex) { return vertex.x != not_snapped; };
    const bool all_placed = std::all_of(placed, placed + 3, has_place);
    const bool is_rejected =
        std::none_of(placed, placed + 3, has_place) && (placed[0].y & placed[1].y & placed[2].y) != 0;
    if (!all_placed && !is_rejected) {
      expected.slow.push_back(i);
      continue;
    }
    const AssembledTriangle triangle =
        assemble(c.vertices, t, c.mirrored, c.cull, ClipVolume{}, expected.counters);
    CHECK((triangle.fate == TriangleFate::rejected) == is_rejected);
    if (triangle.fate == TriangleFate::accepted)
      set_up(triangle, 100 + i, c.viewport, expected.counters, pieces);
  }
  for (const ScreenTriangle& piece : pieces) {
    if (!append_triangle(piece, TileGrid(c.target), expected.primitives)) ++expected.counters.zero_area;
  }
  return expected;
}

/// The kernel writes fragments by vectors, in another order.
std::vector<std::array<std::uint32_t, 3>> sorted(const KeptFragments& fragments, std::size_t count) {
  const ConstFragmentArrays all = fragments.all();
  std::vector<std::array<std::uint32_t, 3>> words;
  for (std::size_t i = 0; i < count; ++i) {
    words.push_back({all.primitive[i], all.place[i], static_cast<std::uint32_t>(all.depth[i])});
  }
  std::sort(words.begin(), words.end());
  return words;
}

void check_counters(const Counters& actual, const Counters& expected) {
  CHECK(actual.triangles == expected.triangles);
  CHECK(actual.trivially_accepted == expected.trivially_accepted);
  CHECK(actual.trivially_rejected == expected.trivially_rejected);
  for (int i = 0; i < 6; ++i) CHECK(actual.outside[i] == expected.outside[i]);
  CHECK(actual.back_facing == expected.back_facing);
  CHECK(actual.edge_on == expected.edge_on);
  CHECK(actual.culled == expected.culled);
  CHECK(actual.screen_triangles == expected.screen_triangles);
  CHECK(actual.zero_area == expected.zero_area);
  CHECK(actual.reversed == expected.reversed);
}

void check_set_up(const Case& c, Isa isa) {
  const Expected expected = by_the_plain_path(c);
  const auto count = static_cast<std::uint32_t>(c.triangles.size());
  ScreenPrimitives out;
  out.make_room(count);
  std::vector<std::uint32_t> slow(count);
  SetUpWork work{};
  work.indices = &c.triangles[0].x;
  work.last = count;
  work.first_primitive = 100;
  work.positions = &c.positions[0].x;
  work.clip_from_object = glm::value_ptr(c.matrix);
  work.placed = c.placed.data();
  work.nearness = c.nearness.data();
  work.width = c.viewport.width;
  work.height = c.viewport.height;
  work.target_left = c.target.left;
  work.target_top = c.target.top;
  work.target_right = c.target.right();
  work.target_bottom = c.target.bottom();
  work.tile_columns = TileGrid(c.target).columns;
  set_culling(work, c.cull, c.mirrored);
  work.large = out.large.data();
  work.small_bounds = out.small_bounds.data();
  work.small_refs = out.small_refs.data();
  work.fragments = out.fragments.from(0);
  work.slow = slow.data();
  Counters counters;
  const SetUpResult result = set_up_kernel(isa)(work, counters);
  REQUIRE(result.large == expected.primitives.large_count);
  REQUIRE(result.small == expected.primitives.small_count);
  for (std::size_t i = 0; i < result.large; ++i) {
    CAPTURE(i);
    CHECK(std::memcmp(&out.large[i], &expected.primitives.large[i], large_bytes) == 0);
  }
  out.make_room_for_ready(result.small);
  set_up_small_kernel(isa)(&work, out.small_refs.data(), result.small, out.small.data());
  for (std::size_t i = 0; i < result.small; ++i) {
    CAPTURE(i);
    CHECK(std::memcmp(&out.small[i], &expected.primitives.small[i], small_bytes) == 0);
    CHECK(std::memcmp(&out.small_bounds[i], &expected.primitives.small_bounds[i], sizeof(SmallBounds)) == 0);
  }
  const bool same_fragments = sorted(out.fragments, result.fragments) ==
                              sorted(expected.primitives.fragments, expected.primitives.fragment_count);
  CHECK(same_fragments);
  CHECK(std::vector(slow.begin(), slow.begin() + static_cast<std::ptrdiff_t>(result.slow)) == expected.slow);
  check_counters(counters, expected.counters);
}

/// Triangles of neighbouring vertices; some repeat a vertex.
std::vector<glm::uvec3> random_triangles(Random& random, int vertices, int count, int spread) {
  std::vector<glm::uvec3> triangles;
  const auto last = static_cast<unsigned>(vertices - 1);
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<unsigned>(random.below(vertices));
    const auto near_by = [&] { return std::min(last, first + static_cast<unsigned>(random.below(spread))); };
    triangles.emplace_back(first, near_by(), near_by());
  }
  return triangles;
}

void check_random(Random& random, double size) {
  const Viewport viewport{1 + random.below(2000), 1 + random.below(2000)};
  const auto positions = random_positions(random, 1 + random.below(300), size);
  const glm::dmat4 matrix = random_matrix(random);
  const auto triangles =
      random_triangles(random, static_cast<int>(positions.size()), 1 + random.below(400), 6);
  ClipVertices reference;
  transform_vertices(positions, matrix, reference);
  const Rect whole{0, 0, viewport.width, viewport.height};
  const Rect part{viewport.width / 3, viewport.height / 4, viewport.width / 2 + 1, viewport.height / 2 + 1};
  for (const Isa isa : available_isas()) {
    if (isa == Isa::reference) continue;
    CAPTURE(name_of(isa));
    const Transformed vertices = transformed(positions, matrix, viewport, isa);
    check_vertices(positions, matrix, viewport, vertices);
    for (const Cull cull : {Cull::none, Cull::back, Cull::front}) {
      for (const bool mirrored : {false, true}) {
        check_set_up({positions, matrix, reference, vertices.placed, vertices.nearness, triangles, viewport,
                      mirrored ? part : whole, mirrored, cull},
                     isa);
      }
    }
  }
}

}  // namespace

TEST_CASE("The vector kernels transform and set up as the plain stages do, to the bit") {
  Random random{21};
  for (const double size : {0.01, 0.3, 1.0, 10.0}) {
    for (int round = 0; round < 5; ++round) check_random(random, size);
  }
}

TEST_CASE("[long] The vector kernels against the plain stages: many scenes") {
  Random random{22};
  for (int round = 0; round < 500; ++round)
    check_random(random, 0.01 * static_cast<double>(1 << random.below(11)));
}

TEST_CASE("Vertices of the vector kernels at the bounds of the view volume") {
  // Identity: object space is clip space with w = 1.
  const float below = std::nextafter(1.0f, 0.0f), above = std::nextafter(1.0f, 2.0f);
  std::vector<glm::vec3> positions;
  for (const float x : {-above, -1.0f, -below, -0.0f, 0.0f, below, 1.0f, above}) {
    positions.emplace_back(x, 0.0f, 0.5f);
    positions.emplace_back(0.0f, x, 0.5f);
    positions.emplace_back(0.0f, 0.0f, x);
  }
  const Viewport viewport{640, 480};
  for (const Isa isa : available_isas()) {
    if (isa == Isa::reference) continue;
    check_vertices(positions, glm::dmat4(1.0), viewport,
                   transformed(positions, glm::dmat4(1.0), viewport, isa));
  }
  // An infinite w, w = 0 and a NaN are nowhere.
  for (const double w : {infinity, 0.0, -1.0, not_a_number}) {
    glm::dmat4 matrix(1.0);
    matrix[3].w = w;
    for (const Isa isa : available_isas()) {
      if (isa == Isa::reference) continue;
      for (const PlacedVertex& vertex : transformed(positions, matrix, viewport, isa).placed)
        CHECK(vertex.x == not_snapped);
    }
  }
}
