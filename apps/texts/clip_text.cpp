#include "clip_text.hpp"

#include <array>

#include "text.hpp"
#include "trace_text.hpp"

namespace velum_app {
namespace {

using namespace velum;

/// What must not be negative, in the order of the planes.
constexpr std::array<const char*, clip_plane_count> formulas{"z",     "w - z", "x + w",
                                                             "w - x", "y + w", "w - y"};

const TracedVertex& vertex_of(const ClipTrace& trace, int number) {
  return trace.vertices[static_cast<std::size_t>(number)];
}

std::string numbers_text(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += " " + std::to_string(number);
  return text.empty() ? " none" : text;
}

std::string vertex_line(const ClipTrace& trace, int number) {
  const TracedVertex& vertex = vertex_of(trace, number);
  return "  " + std::to_string(number) + "  " + tuple_text(vertex.position) + "  " +
         outcode_text(vertex.code) + '\n';
}

std::string cut_text(const ClipTrace& trace, int number) {
  const TracedVertex& v = vertex_of(trace, number);
  return "    vertex " + std::to_string(number) + " on the edge from " + std::to_string(v.inside) + " to " +
         std::to_string(v.outside) + ": t = " + long_text(v.d_in) + " / (" + long_text(v.d_in) + " - " +
         operand_text(v.d_out) + ") = " + long_text(v.t) + "\n      v" + std::to_string(v.inside) +
         " + t * (v" + std::to_string(v.outside) + " - v" + std::to_string(v.inside) +
         ") = " + tuple_text(v.position) + "  " + outcode_text(v.code) + '\n';
}

std::string step_text(const ClipTrace& trace, const ClipStep& step, const std::vector<int>& before) {
  const auto index = static_cast<std::size_t>(step.plane);
  std::string text = "\nPlane " + std::to_string(index) + ", " + clip_planes[index].name + ": inside is " +
                     formulas[index] + " >= 0\n";
  if (before.empty()) return text + "    nothing is left to cut\n";
  text += "    values:";
  for (const int number : before) {
    text += "  " + std::to_string(number) + ": " +
            long_text(signed_value(clip_planes[index], vertex_of(trace, number).position));
  }
  text += '\n';
  if (!step.cuts) return text + "    cuts nothing off\n";
  text += "    cuts off:" + numbers_text(step.removed) + '\n';
  for (const int number : step.made) text += cut_text(trace, number);
  return text + "    left:" + numbers_text(step.polygon) + '\n';
}

std::string result_text(const ClipTrace& trace) {
  if (trace.result.empty()) return "\nNothing is left.\n";
  std::string text = "\nLeft is the polygon" + numbers_text(trace.result) + "; divided by w:\n";
  for (const int number : trace.result) {
    const glm::dvec4& v = vertex_of(trace, number).position;
    text +=
        "  " + std::to_string(number) + "  " + tuple_text(glm::dvec3(v.x / v.w, v.y / v.w, v.z / v.w)) + '\n';
  }
  return text;
}

}  // namespace

std::string clip_text(const ClipTrace& trace) {
  std::string text = "\nVertices in clip space (x, y, z, w), with outcodes\n";
  for (int number = 0; number < 3; ++number) text += vertex_line(trace, number);
  text += "  AND " + bits_text(trace.all_outside) + ", OR " + bits_text(trace.some_outside) + ": ";
  switch (trace.verdict) {
    case ClipVerdict::accepted:
      return text + "accepted, no vertex is outside of any plane\n" + result_text(trace);
    case ClipVerdict::rejected:
      return text +
             (trace.all_outside != 0 ? "rejected, all are outside (" + plane_names(trace.all_outside) + ")"
                                     : std::string("rejected, a coordinate is not finite")) +
             '\n';
    case ClipVerdict::clipped:
    case ClipVerdict::clipped_away:
      break;
  }
  text += "to be cut. Cuts run from the inside end: t = d_in / (d_in - d_out).\n";
  std::vector<int> before{0, 1, 2};
  for (const ClipStep& step : trace.steps) {
    text += step_text(trace, step, before);
    before = step.polygon;
  }
  return text + result_text(trace);
}

}  // namespace velum_app
