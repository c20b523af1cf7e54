#include "fragment_text.hpp"

#include <bit>

#include "text.hpp"
#include "trace_text.hpp"

namespace velum_app {
namespace {

using namespace velum;

std::string owner_text(const EdgeAtCentre& edge) {
  if (!edge.owns_its_points()) return "neither top nor left: less 1 = " + std::to_string(edge.value);
  return edge.to.y == edge.from.y ? "a top edge" : "a left edge";
}

/// "E01 = (dx)·(cy - ay) - (dy)·(cx - ax) = …"
std::string edge_text(const EdgeAtCentre& edge, const SnappedVertex& centre, int from, int to) {
  const auto plain = [](std::int64_t v) { return v < 0 ? "(" + std::to_string(v) + ")" : std::to_string(v); };
  return "E" + std::to_string(from) + std::to_string(to) + " = " + plain(edge.to.x - edge.from.x) + " * (" +
         std::to_string(centre.y) + " - " + plain(edge.from.y) + ") - " + plain(edge.to.y - edge.from.y) +
         " * (" + std::to_string(centre.x) + " - " + plain(edge.from.x) +
         ") = " + std::to_string(edge.cross) + ", " + owner_text(edge) +
         (edge.value >= 0 ? "; >= 0" : "; < 0");
}

std::string depth_text(const CoveringFragment& fragment, const PixelExplanation& pixel) {
  const DepthPlane& plane = fragment.triangle.depth;
  return "r = (" + long_text(plane.r_ref) + " + " + operand_text(plane.dx) + " * (" +
         std::to_string(pixel.x) + " - " + std::to_string(plane.x_ref) + ")) + " + operand_text(plane.dy) +
         " * (" + std::to_string(pixel.y) + " - " + std::to_string(plane.y_ref) +
         ") = " + long_text(fragment.reversed_depth);
}

/// Where the formula left the range of the vertices.
std::string clamp_text(const CoveringFragment& fragment) {
  const DepthPlane& plane = fragment.triangle.depth;
  const std::string range = " the range " + long_text(plane.lower) + " ... " + long_text(plane.upper);
  const bool at_end = fragment.reversed_depth == plane.lower || fragment.reversed_depth == plane.upper;
  return at_end ? "at an end of" + range + " of its vertices, which it never leaves"
                : "within" + range + " of its vertices";
}

std::string hexadecimal_text(std::uint32_t bits) {
  std::string text(8, '0');
  for (std::size_t i = 8; i-- > 0; bits >>= 4) text[i] = "0123456789abcdef"[bits & 15u];
  return text;
}

std::string verdict_text(const CoveringFragment& fragment, const PixelExplanation& pixel) {
  const CoveringFragment& seen = pixel.fragments[0];
  const std::string winner = kind_name(seen.place.kind) + (" " + std::to_string(seen.primitive));
  switch (fragment.outcome) {
    case FragmentOutcome::seen: {
      if (pixel.fragments.size() == 1) return "wins: it is the only one";
      const bool tie = pixel.fragments[1].outcome == FragmentOutcome::higher_id;
      return "wins: r = " + long_text(seen.reversed_depth) + " is the largest" +
             (tie ? ", and of those that have it the id " + std::to_string(seen.primitive) + " is the lowest"
                  : "");
    }
    case FragmentOutcome::farther:
      return "loses to " + winner + ": farther, its r is smaller by " +
             long_text(static_cast<double>(seen.reversed_depth) - fragment.reversed_depth);
    case FragmentOutcome::higher_id:
      return "loses to " + winner + ": a tie, the same depth bits; the lower id is seen";
    case FragmentOutcome::same_triangle:
      return "the same triangle again: snapping reversed a sliver, so two of its pieces overlap here";
  }
  return {};
}

std::string capitalised(std::string word) {
  word[0] = static_cast<char>(word[0] - 'a' + 'A');
  return word;
}

std::string fragment_text(const CoveringFragment& fragment, const PixelExplanation& pixel,
                          const Scene& scene) {
  std::string text = "\n  " + capitalised(kind_name(fragment.place.kind)) + " " +
                     std::to_string(fragment.primitive) + " (" + place_text(scene, fragment.place) + ")";
  if (fragment.place.kind != PrimitiveKind::triangle)
    text += ", one of the two halves of its outline on the picture";
  else if (fragment.pieces > 1)
    text += ", piece " + std::to_string(fragment.piece) + " of " + std::to_string(fragment.pieces);
  text += "\n    corners, clockwise as seen" + std::string(fragment.is_turned ? " (P1 and P2 swapped)" : "") +
          ":";
  for (int i = 0; i < 3; ++i)
    text +=
        " P" + std::to_string(i) + " " + tuple_text(fragment.triangle.vertices[static_cast<std::size_t>(i)]);
  text += '\n';
  for (int i = 0; i < 3; ++i)
    text +=
        "    " + edge_text(fragment.edges[static_cast<std::size_t>(i)], pixel.centre, i, (i + 1) % 3) + '\n';
  text += "    " + depth_text(fragment, pixel) + '\n';
  text += "      " + clamp_text(fragment) + "; z = 1 - r = " + long_text(fragment.depth()) + "; bits 0x" +
          hexadecimal_text(std::bit_cast<std::uint32_t>(fragment.reversed_depth)) + '\n';
  return text + "    " + verdict_text(fragment, pixel) + '\n';
}

}  // namespace

std::string fragments_text(const PixelExplanation& pixel, const Scene& scene) {
  std::string text = "The centre is (" + std::to_string(pixel.x) + " + 1/2, " + std::to_string(pixel.y) +
                     " + 1/2), in 1/256 pixel " + tuple_text(pixel.centre) + ".\n";
  if (pixel.fragments.empty()) return text + "Nothing covers it: the background is seen.\n";
  const std::size_t count = pixel.fragments.size();
  text += (count == 1 ? "One fragment covers" : std::to_string(count) + " fragments cover") +
          std::string(" it, nearest first. Inside is where all three edge values are >= 0:\n") +
          "  Eab = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax), less 1 on edges that are neither top nor "
          "left\n" +
          "  r   = (r_ref + dx * (x - x_ref)) + dy * (y - y_ref), in float32; the largest r is seen\n";
  for (const CoveringFragment& fragment : pixel.fragments) text += fragment_text(fragment, pixel, scene);
  return text;
}

}  // namespace velum_app
