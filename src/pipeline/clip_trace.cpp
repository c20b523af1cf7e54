#include "clip_trace.hpp"

#include <algorithm>
#include <span>

#include "../base/contract.hpp"
#include "../base/floating_point.hpp"
#include "../clipping/cut.hpp"

namespace velum {
namespace {

/// The vertices met so far, and the polygon by their numbers.
class Tracer {
 public:
  Tracer(ClipTrace& trace, const std::array<glm::dvec4, 3>& triangle) : trace_(trace) {
    for (const glm::dvec4& vertex : triangle) {
      polygon_.push_back(add({vertex, outcode(vertex), -1, -1, 0.0, 0.0, 0.0, ClipPlane::front}));
    }
  }

  ClipStep step(ClipPlane plane) {
    ClipStep result;
    result.plane = plane;
    std::vector<int> next;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const int from = polygon_[i];
      const int to = polygon_[i + 1 < polygon_.size() ? i + 1 : 0];
      const double d_from = value(plane, from);
      const double d_to = value(plane, to);
      if (d_from >= 0.0) next.push_back(from);
      if (d_from < 0.0) result.removed.push_back(from);
      if (d_from > 0.0 && d_to < 0.0) next.push_back(cut(from, to, plane, result));
      if (d_from < 0.0 && d_to > 0.0) next.push_back(cut(to, from, plane, result));
    }
    result.cuts = !result.removed.empty();
    check(clip_against(positions(), plane).span(), next);
    polygon_ = next;
    result.polygon = polygon_;
    return result;
  }

  /// The numbers of the vertices that clip_triangle() kept.
  std::vector<int> kept(std::span<const glm::dvec4> clipped) const {
    std::vector<int> numbers;
    std::size_t at = 0;
    for (const glm::dvec4& vertex : clipped) {
      while (at < polygon_.size() && position(polygon_[at]) != vertex) ++at;
      VELUM_REQUIRE(at < polygon_.size(), {"traced vertices", polygon_.size()});
      numbers.push_back(polygon_[at++]);
    }
    return numbers;
  }

 private:
  int add(const TracedVertex& vertex) {
    trace_.vertices.push_back(vertex);
    return static_cast<int>(trace_.vertices.size()) - 1;
  }

  const glm::dvec4& position(int number) const {
    return trace_.vertices[static_cast<std::size_t>(number)].position;
  }

  double value(ClipPlane plane, int number) const {
    return signed_value(clip_planes[static_cast<std::size_t>(plane)], position(number));
  }

  int cut(int inside, int outside, ClipPlane plane, ClipStep& result) {
    const Cut made = cut_edge(position(inside), position(outside), plane);
    const int number = add({made.point, outcode(made.point), inside, outside, made.t, value(plane, inside),
                            value(plane, outside), plane});
    result.made.push_back(number);
    return number;
  }

  ClippedPolygon positions() const {
    ClippedPolygon polygon;
    for (const int number : polygon_)
      polygon.vertices[static_cast<std::size_t>(polygon.count++)] = position(number);
    return polygon;
  }

  /// What is told must be what happened.
  void check(std::span<const glm::dvec4> clipped, const std::vector<int>& numbers) const {
    VELUM_REQUIRE(clipped.size() == numbers.size(), {"clipped", clipped.size()}, {"traced", numbers.size()});
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      VELUM_REQUIRE(clipped[i] == position(numbers[i]), {"vertex", numbers[i]});
    }
  }

  ClipTrace& trace_;
  std::vector<int> polygon_;
};

ClipVerdict verdict_of(const ClipTrace& trace, const ClippedPolygon& clipped, bool finite) {
  if (!finite || trace.all_outside != 0) return ClipVerdict::rejected;
  if (clipped.count == 0) return ClipVerdict::clipped_away;
  return trace.some_outside == 0 ? ClipVerdict::accepted : ClipVerdict::clipped;
}

}  // namespace

ClipTrace trace_clipping(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
  const FloatingPointScope floating_point;
  ClipTrace trace;
  Tracer tracer(trace, {a, b, c});
  const auto code = [&trace](std::size_t i) { return static_cast<unsigned>(trace.vertices[i].code); };
  trace.all_outside = static_cast<Outcode>(code(0) & code(1) & code(2));
  trace.some_outside = static_cast<Outcode>(code(0) | code(1) | code(2));
  const ClippedPolygon clipped = clip_triangle(a, b, c);
  trace.verdict = verdict_of(trace, clipped, is_finite(a) && is_finite(b) && is_finite(c));
  const bool stops_at_once = trace.verdict == ClipVerdict::rejected;
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    const ClipPlane plane = static_cast<ClipPlane>(i);
    if (stops_at_once) {
      trace.steps[i].plane = plane;
    } else {
      trace.steps[i] = tracer.step(plane);
    }
  }
  trace.result = tracer.kept(clipped.span());
  return trace;
}

}  // namespace velum
