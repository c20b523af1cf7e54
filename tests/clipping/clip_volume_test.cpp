// The guard band: as large as its header says, and as exact as the view volume.
#include "clipping/clip_volume.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "clipping/clip_polygon.hpp"
#include "clipping_data.hpp"

using namespace velum;

TEST_CASE("the guard band is the largest power of two that keeps to its width") {
  CHECK(guard_band(1) == 32768.0);
  CHECK(guard_band(64) == 512.0);
  CHECK(guard_band(1080) == 16.0);
  CHECK(guard_band(1920) == 16.0);
  CHECK(guard_band(16384) == 2.0);
  CHECK(guard_band(16385) == 1.0);
  CHECK(guard_band(32768) == 1.0);
  for (int pixels = 1; pixels <= widest_guard_band; ++pixels) {
    const double factor = guard_band(pixels);
    // The farthest places in it, in 1/256 pixel, as snap() has them.
    const double low = 128.0 * pixels * (1.0 - factor), high = 128.0 * pixels * (1.0 + factor);
    if (low < -0x1p23 || high > 0x1p23 || high - low > 0x1p23) FAIL_CHECK(pixels);
  }
}

TEST_CASE("the exact policy is the canonical view volume") {
  const ClipVolume exact = clip_volume(ClipPolicy::exact, 640, 480);
  CHECK(exact.x == 1.0);
  CHECK(exact.y == 1.0);
  const ClipVolume guard = clip_volume(ClipPolicy::guard, 640, 480);
  CHECK(guard.x == 32.0);
  CHECK(guard.y == 64.0);
  Random random{5};
  int broken = 0;
  for (int i = 0; i < 10000; ++i) {
    const glm::dvec4 p = random_point(random);
    broken += outcode(p, exact) != outcode(p);
    broken += (outcode(p, guard) & 3) != (outcode(p) & 3);  // near and far are what they were
    broken += outcode(p) == 0 && outcode(p, guard) != 0;    // and the sides are farther out
  }
  CHECK(broken == 0);
}

TEST_CASE("clipping by a guard band is clipping by the view volume after shrinking x and y, bit for bit") {
  // Powers of two multiply exactly, so whatever holds for the view volume holds for the guard band.
  const ClipVolume guard{16.0, 64.0};
  const auto shrunk = [&](const glm::dvec4& p) { return glm::dvec4(p.x / guard.x, p.y / guard.y, p.z, p.w); };
  Random random{6};
  int broken = 0, cut = 0;
  for (int i = 0; i < 20000; ++i) {
    Triangle t = random_triangle(random);
    for (glm::dvec4& p : t) {
      p.x *= guard.x;
      p.y *= guard.y;
    }
    const ClippedPolygon actual = clip_triangle(t[0], t[1], t[2], guard);
    const ClippedPolygon expected = clip_triangle(shrunk(t[0]), shrunk(t[1]), shrunk(t[2]));
    bool same = actual.count == expected.count && actual.cut_by == expected.cut_by;
    for (int k = 0; same && k < actual.count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      same = same_bits(shrunk(actual.vertices[at]), expected.vertices[at]) &&
             needs_no_cut(actual.vertices[at], guard);
    }
    broken += same ? 0 : 1;
    cut += actual.count >= 3 && actual.cut_by != 0;
  }
  CHECK(broken == 0);
  CHECK(cut > 2000);
}

TEST_CASE("a vertex needs no cut up to the very edge of the guard band") {
  const ClipVolume guard{16.0, 8.0};
  CHECK(needs_no_cut({32.0, -16.0, 1.0, 2.0}, guard));
  CHECK_FALSE(needs_no_cut({std::nextafter(32.0, 33.0), 0.0, 1.0, 2.0}, guard));
  CHECK_FALSE(needs_no_cut({0.0, std::nextafter(-16.0, -17.0), 1.0, 2.0}, guard));
  CHECK_FALSE(needs_no_cut({0.0, 0.0, -1e-300, 2.0}, guard));
  CHECK_FALSE(needs_no_cut({0.0, 0.0, 0.0, 0.0}, guard));
  CHECK_FALSE(needs_no_cut({std::nan(""), 0.0, 1.0, 2.0}, guard));
}
