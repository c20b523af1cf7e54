#include "pipeline/sample_resolve.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "random.hpp"
#include "visibility/sample_positions.hpp"
#include "visibility/screen_triangle.hpp"

using namespace velum;

TEST_CASE("the centroid of covered samples lies in the triangle; that of all is the centre") {
  Random random{21};
  int checked = 0;
  for (int i = 0; i < 3000; ++i) {
    std::array<SnappedVertex, 3> v;
    for (SnappedVertex& vertex : v) vertex = {random.below(600) - 300, random.below(600) - 300};
    if (doubled_area(v) < 0) std::swap(v[1], v[2]);
    const int count = i % 3 == 0 ? 4 : (i % 3 == 1 ? 8 : 16);
    std::uint32_t covered = 0;
    for (int k = 0; k < count; ++k) {
      const SamplePosition& s = sample_positions(count)[static_cast<std::size_t>(k)];
      const SnappedVertex at{s.x, s.y};
      const bool inside = doubled_area({v[0], v[1], at}) > 0 && doubled_area({v[1], v[2], at}) > 0 &&
                          doubled_area({v[2], v[0], at}) > 0;
      covered |= inside ? 1u << k : 0u;
    }
    if (covered == 0) continue;
    ++checked;
    const glm::dvec2 at = centroid_of(covered, count) * 256.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const SnappedVertex& a = v[k];
      const SnappedVertex& b = v[(k + 1) % 3];
      CHECK((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x) > 0.0);
    }
  }
  CHECK(checked > 500);
  for (const int count : {4, 8, 16}) CHECK(centroid_of(all_samples(count), count) == glm::dvec2(0.0));
}

TEST_CASE("equal samples resolve to themselves; a highlight beyond white does not win over its neighbours") {
  Random random{22};
  for (const int count : {4, 8, 16}) {
    for (int i = 0; i < 1000; ++i) {
      const auto f = [&] { return static_cast<float>(random.uniform()); };
      const float alpha = i % 2 == 0 ? 1.0f : f();
      const glm::vec4 colour(f() * alpha, f() * alpha, f() * alpha, alpha);
      glm::vec4 samples[most_samples];
      std::fill(samples, samples + count, colour);
      const glm::vec3 straight = glm::vec3(colour) / alpha;
      CHECK(resolved(samples, count) == srgb_from_linear(glm::vec4(straight, alpha)));
    }
  }
  glm::vec4 samples[4] = {{9, 9, 9, 1}, {9, 9, 9, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}};
  CHECK(resolved(samples, 4) == Rgba8{188, 188, 188, 255});
}
