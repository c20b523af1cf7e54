// The raster: pieces, depth plane, spans, z per pixel, and who wins a pixel.
#include "blocks.hpp"
#include "pixel_table.hpp"
#include "spans.hpp"
#include "table.hpp"
#include "text.hpp"
#include "trace_text.hpp"

namespace velum_docs {
namespace {

using namespace velum;
using velum_app::fixed_text;
using velum_app::number_text;

std::string pieces_block(const Subject& subject) {
  Table table({"piece", "corners in 1/256 pixel", "twice the area"});
  for (std::size_t i = 0; i < subject.triangle.pieces.size(); ++i) {
    const std::array<SnappedVertex, 3>& v = subject.triangle.pieces[i].vertices;
    std::string corners;
    for (const SnappedVertex& corner : v)
      corners += (corners.empty() ? "" : " ") + velum_app::tuple_text(corner);
    table.add({std::to_string(i), corners, std::to_string(doubled_area(v))});
  }
  return table.markdown();
}

std::string plane_block(const Subject& subject) {
  const DepthPlane& plane = subject.triangle.pieces[0].depth;
  return fenced("r = (" + velum_app::long_text(plane.r_ref) + " + " + velum_app::operand_text(plane.dx) +
                " * (x - " + std::to_string(plane.x_ref) + ")) + " + velum_app::operand_text(plane.dy) +
                " * (y - " + std::to_string(plane.y_ref) + ")     kept within " +
                velum_app::long_text(plane.lower) + " ... " + velum_app::long_text(plane.upper) + "\n");
}

std::string spans_block(const SpanTable& table) {
  Table text({"row", "first", "last", "z at first", "z at last"});
  for (const Span& span : table.spans()) {
    text.add({std::to_string(span.row), std::to_string(span.first), std::to_string(span.last),
              fixed_text(1.0 - table.reversed_depth(span.first, span.row), 6),
              fixed_text(1.0 - table.reversed_depth(span.last, span.row), 6)});
  }
  return text.text();
}

std::string fragments_block(const PixelExplanation& pixel) {
  Table table({"triangle", "E01", "E12", "E20", "r", "z = 1 - r", ""});
  for (const CoveringFragment& fragment : pixel.fragments) {
    const auto edge = [&](std::size_t i) { return std::to_string(fragment.edges[i].value); };
    table.add({std::to_string(fragment.primitive), edge(0), edge(1), edge(2),
               velum_app::long_text(fragment.reversed_depth), velum_app::long_text(fragment.depth()),
               fragment.outcome == FragmentOutcome::seen ? "is seen: the largest r" : "is farther"});
  }
  return table.markdown();
}

}  // namespace

void add_raster_blocks(const Subject& subject, Docs& docs) {
  const SpanTable table(subject);
  docs.blocks["pieces"] = pieces_block(subject);
  docs.blocks["depth plane"] = plane_block(subject);
  docs.blocks["spans"] = spans_block(table);
  docs.blocks["z per pixel"] = pixel_table(
      table, [&](int x, int y) { return fixed_text(1.0 - table.reversed_depth(x, y), 3).substr(1); });
  docs.blocks["z in 0...255"] = pixel_table(table, [&](int x, int y) {
    return std::to_string(quantised_depth(DepthFormat::z8, table.reversed_depth(x, y)));
  });
  docs.blocks["pixel"] = fragments_block(subject.pixel);
}

}  // namespace velum_docs
