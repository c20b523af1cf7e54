// From object space to the picture: the stages, clipping, the divide and the two pixel conventions.
#include <cmath>

#include "blocks.hpp"
#include "clip_text.hpp"
#include "matrix_text.hpp"
#include "table.hpp"
#include "text.hpp"
#include "trace_text.hpp"

namespace velum_docs {
namespace {

using namespace velum;
using velum_app::number_text;

std::string tuple(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "(" : ", ") + number_text(value, 6);
  return text + ")";
}

std::string tuple(const glm::dvec4& v) {
  return tuple({v.x, v.y, v.z, v.w});
}

std::string pair_text(long x, long y) {
  return std::to_string(x) + ", " + std::to_string(y);
}

std::string stages_block(const Subject& subject) {
  std::string text;
  int number = 0;
  for (const Stage& stage : subject.viewing.stages()) {
    text += std::to_string(++number) + ". " + std::string(stage.name) + ": " + std::string(stage.meaning) +
            "\n" + velum_app::long_matrix_text(stage.matrix);
  }
  return fenced(text);
}

std::string vertices_block(const Subject& subject) {
  Table table({"", "vertex 0", "vertex 1", "vertex 2"});
  const auto& v = subject.triangle.vertices;
  const auto row = [&](const std::string& name, auto text_of) {
    table.add({name, text_of(v[0]), text_of(v[1]), text_of(v[2])});
  };
  row("object", [](const VertexTrace& t) { return tuple({t.object.x, t.object.y, t.object.z}); });
  row("world", [](const VertexTrace& t) { return tuple(t.images[0]); });
  const StageList& stages = subject.viewing.stages();
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const bool is_camera = stages[s].name == "M_rot^T";
    row("after `" + std::string(stages[s].name) + "`" +
            (is_camera                ? ": camera"
             : s + 1 == stages.size() ? ": clip"
                                      : ""),
        [s](const VertexTrace& t) { return tuple(t.images[s + 1]); });
  }
  row("outcode", [](const VertexTrace& t) { return velum_app::outcode_text(t.code); });
  return table.markdown();
}

std::string facing_block(const Subject& subject) {
  const double d = subject.triangle.assembled.determinant;
  return "Facing: the determinant of the columns (x, y, w) is " + number_text(d, 6) +
         (d >= 0.0 ? ": counter-clockwise in the picture, a front face.\n"
                   : ": clockwise in the picture, a back face.\n");
}

/// A pixel as the lecture has it, and as velum has it.
std::string lecture_pixel(double x, double y, const Viewport& v) {
  return pair_text(std::lround(std::floor(0.5 * v.width * (x + 1.0))),
                   std::lround(std::floor(0.5 * v.height * (y + 1.0))));
}

std::string places_block(const Subject& subject) {
  Table table({"corner", "canonical x, y, z", "x', y' here (y down)", "snapped, 1/256 pixel",
               "pixel in the lecture (y up)"});
  for (std::size_t i = 0; i < subject.triangle.polygon.size(); ++i) {
    const PlacedPoint& p = subject.triangle.polygon[i];
    table.add({std::to_string(subject.clip.result[i]), tuple({p.ndc.x, p.ndc.y, p.ndc.z}),
               tuple({p.pixel.x, p.pixel.y}), velum_app::tuple_text(p.snapped),
               lecture_pixel(p.ndc.x, p.ndc.y, subject.viewport())});
  }
  return table.markdown();
}

/// The ends and the middle of the range, at which the conventions differ most.
std::string conventions_block() {
  Table table({"canonical x = y", "x', y' here", "pixel in the lecture"});
  const Viewport viewport{8, 6};
  for (const double value : {-1.0, -0.875, 0.0, 0.875, 1.0}) {
    const glm::dvec2 p = viewport.pixel_from_ndc(value, value);
    table.add({number_text(value), tuple({p.x, p.y}), lecture_pixel(value, value, viewport)});
  }
  return table.markdown();
}

}  // namespace

void add_stage_blocks(const Subject& subject, Docs& docs) {
  docs.blocks["stages"] = stages_block(subject);
  docs.blocks["vertices"] = vertices_block(subject);
  docs.blocks["facing"] = facing_block(subject);
  docs.blocks["clipping"] = fenced(velum_app::clip_text(subject.clip).substr(1));
  docs.blocks["places"] = places_block(subject);
  docs.blocks["conventions"] = conventions_block();
}

}  // namespace velum_docs
