// Triangles that cover no pixel centre are found by every kernel as by the plain loop, and only those.
#include "pipeline/empty_triangles.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "random.hpp"
#include "visibility/screen_triangle.hpp"

using namespace velum;

namespace {

constexpr std::uint32_t untouched = 0xDEADBEEFu;

/// Triangles with their vertices, and what a version leaves of them.
struct Cluster {
  std::uint32_t first_vertex = 5;  ///< those before it are another cluster's
  std::vector<PlacedVertex> placed;
  std::vector<std::uint32_t> indices, triangles;
  std::vector<std::uint16_t> corners[3];

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles.push_back(1000 + static_cast<std::uint32_t>(triangles.size()) * 3);
    const std::uint32_t local[3] = {a, b, c};
    for (int v = 0; v < 3; ++v) {
      indices.push_back(first_vertex + local[v]);
      corners[v].push_back(static_cast<std::uint16_t>(local[v]));
    }
  }
};

struct Left {
  std::vector<std::uint32_t> indices, triangles;
  Counters counters{};
};

Left left_of(Cluster cluster, LeaveOutEmpty version, int culled) {
  const std::size_t count = cluster.triangles.size();
  const auto vertices = static_cast<std::uint32_t>(cluster.placed.size()) - cluster.first_vertex;
  std::vector<std::uint16_t> windows;
  for (std::size_t i = 0; i < count; i += window_triangles) {
    const auto from = [&](int v) { return cluster.corners[v].data() + i; };
    windows.push_back(window_of_corners({from(0), from(1), from(2)}, std::min(window_triangles, count - i)));
  }
  // What stands behind is another cluster's.
  for (std::vector<std::uint16_t>& corners : cluster.corners) corners.resize(count + 16, 65535);
  Left left{std::vector<std::uint32_t>(3 * count, untouched),
            std::vector<std::uint32_t>(count + kept_room, untouched)};
  std::vector<std::int32_t> packed(packed_room(vertices));
  const std::uint32_t kept =
      version({cluster.placed.data(),
               cluster.first_vertex,
               vertices,
               cluster.indices.data(),
               {cluster.corners[0].data(), cluster.corners[1].data(), cluster.corners[2].data()},
               windows.data(),
               cluster.triangles.data(),
               static_cast<std::uint32_t>(count),
               culled == 2,
               (culled & 1) != 0,
               (culled & 2) != 0,
               left.indices.data(),
               left.triangles.data(),
               packed.data()},
              left.counters);
  left.indices.resize(3 * std::size_t{kept});
  left.triangles.resize(kept);
  return left;
}

/// Vertices within `size`, in 1/256 pixel; where asked for, some on pixel centres' rows and columns.
Cluster random_cluster(Random& random, int vertices, int triangles, int size, bool on_centres = true) {
  Cluster cluster;
  const std::int32_t x = random.below(60000) - 30000, y = random.below(60000) - 30000;
  cluster.placed.assign(cluster.first_vertex, PlacedVertex{not_snapped, 63});
  const auto coordinate = [&](std::int32_t from) {
    const std::int32_t v = from + random.below(size);
    return on_centres && random.below(4) == 0 ? (v & -256) + 128 : v;
  };
  for (int i = 0; i < vertices; ++i) cluster.placed.push_back({coordinate(x), coordinate(y)});
  const auto vertex = [&] { return static_cast<std::uint32_t>(random.below(vertices)); };
  for (int i = 0; i < triangles; ++i) cluster.add(vertex(), vertex(), vertex());
  return cluster;
}

/// The same with corners near to each other, so that most triangles are looked up in windows.
Cluster swept_cluster(Random& random, int vertices, int triangles, int size, int spread) {
  Cluster cluster = random_cluster(random, vertices, 0, size);
  for (int i = 0; i < triangles; ++i) {
    const int first = (vertices - spread) * i / triangles;
    const auto vertex = [&] { return static_cast<std::uint32_t>(first + random.below(spread)); };
    cluster.add(vertex(), vertex(), vertex());
  }
  return cluster;
}

bool covers_a_centre(const PlacedVertex& a, const PlacedVertex& b, const PlacedVertex& c) {
  std::array<SnappedVertex, 3> v{{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}};
  if (doubled_area(v) == 0) return false;
  if (doubled_area(v) < 0) std::swap(v[1], v[2]);
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  for (int py = (top >> 8) - 1; py <= (bottom >> 8) + 1; ++py) {
    for (int px = (left >> 8) - 1; px <= (right >> 8) + 1; ++px) {
      bool is_covered = true;
      for (std::size_t i = 0; i < 3; ++i) {
        is_covered = is_covered && EdgeFunction::between(v[i], v[(i + 1) % 3], px, py).value >= 0;
      }
      if (is_covered) return true;
    }
  }
  return false;
}

void check_kernels(const Cluster& cluster) {
  for (int culled = 0; culled < 4; ++culled) {
    const Left expected = left_of(cluster, leave_out_empty_reference, culled);
    for (const Isa isa : available_isas()) {
      if (isa == Isa::reference) continue;
      CAPTURE(name_of(isa));
      const Left actual = left_of(cluster, empty_triangles_kernel(isa), culled);
      CHECK(actual.indices == expected.indices);
      CHECK(actual.triangles == expected.triangles);
      CHECK(std::memcmp(&actual.counters, &expected.counters, sizeof(Counters)) == 0);
    }
  }
}

}  // namespace

TEST_CASE("what is left out covers no pixel centre, and little else is left of small triangles") {
  Random random{5};
  std::size_t left_over = 0, covering = 0, left_out = 0;
  for (int round = 0; round < 40; ++round) {
    const Cluster cluster = random_cluster(random, 30, 100, round < 30 ? 150 : 4000, round >= 30);
    const Left left = left_of(cluster, leave_out_empty_reference, 0);
    std::size_t next = 0;
    for (std::size_t i = 0; i < cluster.triangles.size(); ++i) {
      const bool is_left = next < left.triangles.size() && left.triangles[next] == cluster.triangles[i];
      const auto vertex = [&](std::size_t v) { return cluster.placed[cluster.indices[3 * i + v]]; };
      const bool covers = covers_a_centre(vertex(0), vertex(1), vertex(2));
      CHECK((is_left || !covers));
      if (is_left) CHECK(left.indices[3 * next] == cluster.indices[3 * i]);
      next += is_left;
      if (round < 30) {
        left_over += is_left && !covers;
        covering += covers;
        left_out += !is_left;
      }
    }
    CHECK(next == left.triangles.size());
    CHECK(left.counters.triangles + next == cluster.triangles.size());
  }
  CHECK(left_out > 2000);
  CHECK(left_over < covering);
}

TEST_CASE("every kernel leaves out the same triangles as the plain loop") {
  Random random{6};
  for (const int vertices : {3, 15, 16, 17, 63, 64, 65, 128, 129, 400}) {
    for (const int triangles : {1, 15, 16, 33, 200}) {
      for (const int size : {40, 300, 3000, 32200, 33000}) {
        CAPTURE(vertices);
        CAPTURE(triangles);
        CAPTURE(size);
        check_kernels(random_cluster(random, vertices, triangles, size));
      }
    }
  }
}

TEST_CASE("every kernel looks vertices up in windows of neighbours as in the whole") {
  Random random{8};
  for (const int spread : {3, 16, 28, 33}) {
    for (const int size : {40, 300, 3000}) {
      CAPTURE(spread);
      CAPTURE(size);
      check_kernels(swept_cluster(random, 70, 100, size, spread));
      check_kernels(swept_cluster(random, 500, 333, size, spread));
    }
  }
}

TEST_CASE("a window holds the corners of its triangles") {
  const std::uint16_t a[3] = {7, 8, 9}, b[3] = {20, 9, 7}, c[3] = {38, 30, 31};
  CHECK(window_of_corners({a, b, c}, 3) == 7);
  const std::uint16_t far[3] = {38, 39, 31};
  CHECK(window_of_corners({a, b, far}, 1) == 7);
  CHECK(window_of_corners({a, b, far}, 3) == no_window);
}

TEST_CASE("nothing is left out where a vertex has no place, or where there are very many") {
  Random random{7};
  Cluster cluster = random_cluster(random, 20, 50, 300);
  cluster.placed[9] = {not_snapped, 1};
  check_kernels(cluster);
  CHECK(left_of(cluster, leave_out_empty_reference, 0).triangles == cluster.triangles);
  Cluster many = random_cluster(random, 66000, 20, 300);
  check_kernels(many);
  CHECK(left_of(many, leave_out_empty_reference, 0).indices == many.indices);
}
