// The pixel grid: the two conventions for it, and the triangle's spans.
#include <array>
#include <cmath>

#include "blocks.hpp"
#include "paint.hpp"
#include "spans.hpp"

namespace velum_docs {
namespace {

using namespace velum;

constexpr int margin = 40;

void draw_grid(Canvas& canvas, const Rect& pixels, int cell) {
  for (int i = 0; i <= pixels.width; ++i)
    canvas.rectangle(margin + i * cell, margin, 1, pixels.height * cell + 1, grid_colour);
  for (int i = 0; i <= pixels.height; ++i)
    canvas.rectangle(margin, margin + i * cell, pixels.width * cell + 1, 1, grid_colour);
}

/// One pixel convention on a picture of 8×6: where (-0.875, -0.875) … go.
Image<Rgba8> convention(const char* title, bool lecture) {
  constexpr int cell = 40, columns = 8, rows = 6;
  constexpr Viewport viewport{columns, rows};
  Canvas canvas(2 * margin + columns * cell, 2 * margin + rows * cell + 10, paper);
  const glm::dvec2 corner(margin, margin);
  canvas.text({margin, 8}, title, 2, ink);
  const std::array<glm::dvec2, 3> triangle{glm::dvec2{-0.7, -0.6}, {0.85, -0.3}, {0.1, 0.8}};
  for (const glm::dvec2& p : triangle) {
    const glm::dvec2 place = viewport.pixel_from_ndc(p.x, p.y);
    // The lecture's row counts from below: the same cell, another number.
    canvas.rectangle(margin + static_cast<int>(place.x) * cell, margin + static_cast<int>(place.y) * cell,
                     cell, cell, with_alpha(blue, 60));
  }
  draw_grid(canvas, {0, 0, columns, rows}, cell);
  for (int i = 0; i < columns; ++i)
    canvas.text({margin + (i + 0.5) * cell, margin + rows * cell + 8}, std::to_string(i), 2, ink,
                TextAnchor::middle);
  for (int i = 0; i < rows; ++i)
    canvas.text({margin - 10, margin + (i + 0.5) * cell - 6}, std::to_string(lecture ? rows - 1 - i : i), 2,
                ink, TextAnchor::right);
  std::array<glm::dvec2, 3> on_page;
  for (std::size_t i = 0; i < 3; ++i) {
    on_page[i] = corner + static_cast<double>(cell) * viewport.pixel_from_ndc(triangle[i].x, triangle[i].y);
  }
  canvas.outline(on_page, 1.5, red);
  for (int i = 0; i < columns * rows; ++i) {
    const glm::dvec2 centre = corner + glm::dvec2(i % columns + 0.5, i / columns + 0.5) * double{cell};
    const double half = 0.5 * cell;
    canvas.disc(lecture ? centre + glm::dvec2(-half, half) : centre, 2.0, ink);
  }
  if (lecture) {
    canvas.text({margin + columns * cell, margin + rows * cell + 8}, "8", 2, red, TextAnchor::middle);
    canvas.text({margin - 10, margin - 6}, "6", 2, red, TextAnchor::right);
  }
  return canvas.picture();
}

void draw_outline(Canvas& canvas, const Subject& subject, const Rect& shown, int cell) {
  const auto on_page = [&](const SnappedVertex& v) {
    return glm::dvec2(margin, margin) +
           glm::dvec2(v.x / 256.0 - shown.left, v.y / 256.0 - shown.top) * static_cast<double>(cell);
  };
  for (const ScreenTriangle& piece : subject.triangle.pieces) {
    std::array<glm::dvec2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = on_page(piece.vertices[i]);
    canvas.outline(corners, 1.5, red);
  }
  for (std::size_t i = 0; i < subject.triangle.polygon.size(); ++i) {
    const glm::dvec2 p = on_page(subject.triangle.polygon[i].snapped);
    canvas.disc(p, 4.0, red);
    canvas.text(p + glm::dvec2(-12, 6), std::to_string(subject.clip.result[i]), 2, red, TextAnchor::middle);
  }
}

void draw_span(Canvas& canvas, const Span& span, const Rect& shown, int cell) {
  const int left = margin + (span.first - shown.left) * cell;
  const int top = margin + (span.row - shown.top) * cell;
  const int width = (span.last + 1 - span.first) * cell;
  canvas.rectangle(left, top, width, cell, with_alpha(blue, 50));
  const glm::dvec2 first(left + 0.5 * cell, top + 0.5 * cell);
  canvas.line(first, first + glm::dvec2(width - cell, 0), 2.0, blue);
  for (int x = span.first; x <= span.last; ++x)
    canvas.disc(first + glm::dvec2((x - span.first) * cell, 0), 3.0, blue);
}

}  // namespace

Image<Rgba8> draw_conventions(const Subject&) {
  const Image<Rgba8> both[] = {convention("here: y down, centres at +1/2", false),
                               convention("lecture: floor, y up", true)};
  return side_by_side(both, 20);
}

Image<Rgba8> draw_spans(const Subject& subject) {
  constexpr int cell = 30;
  const SpanTable table(subject);
  const Rect& covered = table.box();
  const Rect shown{covered.left - 1, covered.top - 1, subject.settings.width - covered.left + 2,
                   covered.height + 3};
  Canvas canvas(2 * margin + shown.width * cell, 2 * margin + shown.height * cell, paper);
  draw_grid(canvas, shown, cell);
  for (int y = shown.top; y < shown.bottom(); ++y) {
    canvas.text({margin - 8, margin + (y - shown.top + 0.5) * cell - 3}, std::to_string(y), 1, ink,
                TextAnchor::right);
    for (int x = shown.left; x < subject.settings.width; ++x)
      canvas.disc(
          glm::dvec2(margin, margin) + glm::dvec2(x - shown.left + 0.5, y - shown.top + 0.5) * double{cell},
          2.0, faint);
  }
  for (int x = shown.left; x < shown.right(); ++x)
    canvas.text({margin + (x - shown.left + 0.5) * cell, margin - 14}, std::to_string(x), 1,
                x < subject.settings.width ? ink : faint, TextAnchor::middle);
  for (const Span& span : table.spans()) draw_span(canvas, span, shown, cell);
  draw_outline(canvas, subject, shown, cell);
  const double edge = margin + (subject.settings.width - shown.left) * double{cell};
  canvas.line({edge, margin}, {edge, margin + shown.height * double{cell}}, 2.0, ink);
  canvas.text({edge - 6, margin + shown.height * double{cell} + 8}, "right edge of the picture", 1, ink,
              TextAnchor::right);
  return canvas.picture();
}

}  // namespace velum_docs
