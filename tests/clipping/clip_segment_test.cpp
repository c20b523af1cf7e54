#include "clipping/clip_segment.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "clipping_data.hpp"
#include "exact_oracle.hpp"

using velum::clip_segment;
using velum::ClippedSegment;
using velum::ClipPlane;
using velum::outcode;

namespace {

/// A segment in the divided volume (w = 1).
ClippedSegment clip(const glm::dvec3& a, const glm::dvec3& b) {
  return clip_segment({a, 1.0}, {b, 1.0});
}

int row(ClipPlane plane) {
  return static_cast<int>(plane);
}

}  // namespace

TEST_CASE("clip_segment: trivial accept returns the same bits, trivial reject nothing") {
  const glm::dvec4 a{-0.5, -0.0, 0.0, 1.0}, b{1.0, 0.25, 1.0, 1.0};
  const ClippedSegment inside = clip_segment(a, b);
  CHECK(inside.visible);
  CHECK(same_bits(inside.a, a));
  CHECK(same_bits(inside.b, b));
  CHECK(inside.t0 == 0.0);
  CHECK(inside.t1 == 1.0);
  CHECK(inside.plane0 == -1);
  CHECK(inside.plane1 == -1);
  CHECK_FALSE(clip({2, 0, 0.5}, {3, 5, 0.5}).visible);
  CHECK_FALSE(clip({0, 0, -1}, {0, 0, -2}).visible);
  // Outside two different planes, yet past the corner.
  CHECK_FALSE(clip({-3, 0, 0.5}, {0, 3, 0.5}).visible);
}

TEST_CASE("clip_segment: says where and by which plane each end was cut") {
  const ClippedSegment across = clip({-3, 0, 0.5}, {5, 0, 0.5});
  CHECK(across.visible);
  CHECK(across.a == glm::dvec4(-1, 0, 0.5, 1));
  CHECK(across.b == glm::dvec4(1, 0, 0.5, 1));
  CHECK(across.t0 == 0.25);
  CHECK(across.t1 == 0.5);
  CHECK(across.plane0 == row(ClipPlane::left));
  CHECK(across.plane1 == row(ClipPlane::right));

  const ClippedSegment depth = clip({0.5, 0.5, 3.0}, {0.5, 0.5, -1.0});
  CHECK(depth.a == glm::dvec4(0.5, 0.5, 1, 1));
  CHECK(depth.b == glm::dvec4(0.5, 0.5, 0, 1));
  CHECK(depth.plane0 == row(ClipPlane::behind));
  CHECK(depth.plane1 == row(ClipPlane::front));

  const ClippedSegment vertical = clip({0, 0, 0.5}, {0, -2, 0.5});
  CHECK(vertical.plane0 == -1);
  CHECK(vertical.plane1 == row(ClipPlane::below));
  CHECK(vertical.t1 == 0.5);
  CHECK(clip({0, 4, 0.5}, {0, 0, 0.5}).plane0 == row(ClipPlane::above));
}

TEST_CASE("clip_segment: through a corner, an edge and a face's diagonal") {
  const ClippedSegment diagonal = clip({-3, -3, -1}, {3, 3, 2});  // corner to corner of the volume
  CHECK(diagonal.visible);
  CHECK(diagonal.a == glm::dvec4(-1, -1, 0, 1));
  CHECK(diagonal.b == glm::dvec4(1, 1, 1, 1));

  const ClippedSegment touching = clip({-2, 0, 0.5}, {0, 2, 0.5});  // only the edge x = -1, y = 1
  CHECK(touching.visible);
  CHECK(touching.a == glm::dvec4(-1, 1, 0.5, 1));
  CHECK(touching.b == touching.a);
  CHECK(touching.t0 == touching.t1);

  const ClippedSegment along = clip({-2, 1, 0}, {2, 1, 0});  // along an edge of the volume
  CHECK(along.a == glm::dvec4(-1, 1, 0, 1));
  CHECK(along.b == glm::dvec4(1, 1, 0, 1));

  const ClippedSegment from_plane = clip({1, 0, 0.5}, {2, 0, 0.5});  // leaves from a plane
  CHECK(from_plane.visible);
  CHECK(from_plane.a == glm::dvec4(1, 0, 0.5, 1));
  CHECK(from_plane.b == from_plane.a);
}

TEST_CASE("clip_segment: through the plane of the eye, only the piece in front is seen") {
  // Behind the eye at w = -1; dividing first would draw the outside piece.
  const glm::dvec4 in{0, 0, 0.5, 1}, behind{0.5, 0, -1.5, -1};
  const ClippedSegment seen = clip_segment(in, behind);
  CHECK(seen.visible);
  CHECK(same_bits(seen.a, in));
  CHECK(seen.b == glm::dvec4(0.125, 0, 0, 0.5));
  CHECK(seen.plane1 == row(ClipPlane::front));
  CHECK(seen.t1 == 0.25);
  // Both ends behind the eye, though they divide to points of the volume.
  CHECK_FALSE(clip_segment({0, 0, -0.5, -1}, {0.25, 0, -0.5, -1}).visible);
  // An end at infinity.
  const ClippedSegment far_away = clip_segment({0, 0, 0.5, 1}, {1, 0, 0, 0});
  CHECK(far_away.b == glm::dvec4(0.5, 0, 0.25, 0.5));
}

TEST_CASE("clip_segment: no point, NaN and infinity show nothing; huge and tiny ends do not overflow") {
  const glm::dvec4 inside{0, 0, 0.5, 1}, none{0, 0, 0, 0};
  CHECK_FALSE(clip_segment(inside, none).visible);
  CHECK_FALSE(clip_segment(none, none).visible);
  CHECK_FALSE(clip_segment(inside, -inside).visible);  // straight at the eye
  for (int axis = 0; axis < 4; ++axis) {
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      glm::dvec4 p = inside;
      p[axis] = bad;
      CHECK_FALSE(clip_segment(inside, p).visible);
      CHECK_FALSE(clip_segment(p, inside).visible);
    }
  }
  const double huge = std::numeric_limits<double>::max();
  const ClippedSegment large = clip_segment({-huge, 0, 0, huge * 0.5}, {huge, 0, 0, huge * 0.5});
  CHECK(large.visible);
  CHECK(large.a == glm::dvec4(-huge * 0.5, 0, 0, huge * 0.5));
  CHECK(large.b == glm::dvec4(huge * 0.5, 0, 0, huge * 0.5));
  const double tiny = std::numeric_limits<double>::denorm_min();
  const ClippedSegment mixed = clip_segment({0, 0, tiny, huge}, {0, 0, -tiny, huge});
  CHECK(mixed.visible);
  CHECK(mixed.b.z == 0.0);
  CHECK(mixed.b.w == huge);
}

namespace {

struct Interval {
  long double t0 = 0, t1 = 1;
};

/// Liang & Barsky 1984, parametric, in long double: the oracle for t.
Interval liang_barsky(const glm::dvec4& a, const glm::dvec4& b) {
  const auto values = [](const glm::dvec4& p) {
    const long double x = p.x, y = p.y, z = p.z, w = p.w;
    return std::array<long double, 6>{z, w - z, w + x, w - x, w + y, w - y};
  };
  Interval visible;
  for (unsigned i = 0; i < 6; ++i) {
    const long double da = values(a)[i], db = values(b)[i];
    if (da < 0 && db < 0) return {1, 0};
    if (da < 0) visible.t0 = std::max(visible.t0, da / (da - db));
    if (db < 0) visible.t1 = std::min(visible.t1, da / (da - db));
  }
  return visible;
}

double largest(const glm::dvec4& p) {
  return std::max(std::max(std::abs(p.x), std::abs(p.y)), std::max(std::abs(p.z), std::abs(p.w)));
}

/// Every promise of clip_segment() that needs no oracle.
bool keeps_its_promises(const glm::dvec4& a, const glm::dvec4& b) {
  const ClippedSegment s = clip_segment(a, b);
  const ClippedSegment swapped = clip_segment(b, a);
  if (s.visible != swapped.visible) return false;
  if (!s.visible) return true;
  bool good = outcode(s.a) == 0 && outcode(s.b) == 0 && s.a.w > 0 && s.b.w > 0;
  good = good && same_bits(s.a, swapped.b) && same_bits(s.b, swapped.a);
  good = good && s.plane0 == swapped.plane1 && s.plane1 == swapped.plane0;
  good = good && 0 <= s.t0 && s.t0 <= s.t1 && s.t1 <= 1;
  good = good && (s.plane0 < 0) == (outcode(a) == 0) && (s.plane1 < 0) == (outcode(b) == 0);
  good = good && std::abs(s.t0 - (1 - swapped.t1)) < 1e-14 && std::abs(s.t1 - (1 - swapped.t0)) < 1e-14;
  const ClippedSegment again = clip_segment(s.a, s.b);
  good = good && again.visible && same_bits(again.a, s.a) && same_bits(again.b, s.b);
  return good && again.plane0 == -1 && again.plane1 == -1 && again.t0 == 0 && again.t1 == 1;
}

struct Tally {
  int visible = 0, hidden = 0, doubtful = 0, broken = 0, wrong = 0;
};

/// A cut point's coordinates are wrong by a few units of 2^-53 of the larger end, and the cut after it sees
/// that divided by how fast the segment runs through the plane.
double t_tolerance(const glm::dvec4& a, const glm::dvec4& b) {
  double slowest = 1.0;
  for (const velum::ClipPlaneRow& plane : velum::clip_planes) {
    const double da = signed_value(plane, a), db = signed_value(plane, b);
    if ((da < 0) != (db < 0))
      slowest = std::min(slowest, std::abs(da - db) / std::max(largest(a), largest(b)));
  }
  return 64 * 0x1p-53 / slowest;
}

void against_liang_barsky(const glm::dvec4& a, const glm::dvec4& b, Tally& tally) {
  const Interval truth = liang_barsky(a, b);
  const ClippedSegment s = clip_segment(a, b);
  const double tolerance = t_tolerance(a, b);
  if (std::abs(truth.t1 - truth.t0) < tolerance) {
    ++tally.doubtful;
    return;
  }
  (s.visible ? tally.visible : tally.hidden) += 1;
  bool good = s.visible == (truth.t0 < truth.t1);
  if (good && s.visible) {
    good = std::abs(s.t0 - truth.t0) < tolerance && std::abs(s.t1 - truth.t1) < tolerance;
    const double reach = 2 * tolerance * std::max(largest(a), largest(b));
    good = good && largest(s.a - (a + s.t0 * (b - a))) < reach && largest(s.b - (a + s.t1 * (b - a))) < reach;
  }
  if (!good) ++tally.wrong;
}

Tally run_segments(std::uint64_t seed, int cases) {
  Random random{seed};
  Tally tally;
  for (int i = 0; i < cases; ++i) {
    const glm::dvec4 a = random_point(random), b = random_point(random);
    if (!keeps_its_promises(a, b)) ++tally.broken;
    // The zero vector is no point; a segment through it has no length on the picture. The oracle knows
    // neither.
    const glm::dvec4 ratio = a * b.w - b * a.w;
    if (largest(ratio) == 0.0) continue;
    against_liang_barsky(a, b, tally);
  }
  return tally;
}

void check_segments(const Tally& tally, int cases) {
  CHECK(tally.broken == 0);
  CHECK(tally.wrong == 0);
  CHECK(tally.visible > cases / 10);
  CHECK(tally.hidden > cases / 10);
  CHECK(tally.doubtful < cases / 4);
}

/// Small integers against exact fractions; returns how often the two differ.
Tally run_exact_segments(std::uint64_t seed, int cases) {
  Random random{seed};
  Tally tally;
  const auto coordinate = [&random] { return static_cast<std::int64_t>(random.next() % 15) - 7; };
  for (int i = 0; i < cases; ++i) {
    const exact::Point a{coordinate(), coordinate(), coordinate(), coordinate()};
    const exact::Point b{coordinate(), coordinate(), coordinate(), coordinate()};
    if (exact::dependent(a, b)) continue;
    const exact::Interval truth = exact::interval(a, b);
    const auto vec = [](const exact::Point& p) { return glm::dvec4(p[0], p[1], p[2], p[3]); };
    const bool visible = clip_segment(vec(a), vec(b)).visible;
    if (!truth.empty && !exact::less(truth.t0, truth.t1)) {
      ++tally.doubtful;  // touches in one point: rounding may decide either way
      continue;
    }
    (visible ? tally.visible : tally.hidden) += 1;
    if (visible == truth.empty) ++tally.wrong;
  }
  return tally;
}

}  // namespace

TEST_CASE("clip_segment: promises and Liang-Barsky in long double, seeded") {
  check_segments(run_segments(1, 20000), 20000);
}

TEST_CASE("clip_segment: accept and reject agree with exact fractions, seeded") {
  check_segments(run_exact_segments(2, 20000), 20000);
}

TEST_CASE("[long] clip_segment: promises, Liang-Barsky and exact fractions") {
  check_segments(run_segments(3, 1000000), 1000000);
  check_segments(run_exact_segments(4, 1000000), 1000000);
}
