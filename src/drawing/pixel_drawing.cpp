#include "pixel_drawing.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "../base/contract.hpp"
#include "../base/floating_point.hpp"
#include "../pipeline/check_request.hpp"
#include "../pipeline/render.hpp"
#include "../shading/shading.hpp"
#include "canvas.hpp"
#include "short_number.hpp"

namespace velum {
namespace {

constexpr Rgba8 paper{255, 255, 255, 255};
constexpr Rgba8 ink{20, 20, 20, 255};
constexpr Rgba8 faint{150, 150, 150, 255};
constexpr Rgba8 grid{190, 190, 190, 255};
constexpr Rgba8 sought{200, 0, 0, 255};

constexpr int margin_left = 56;
constexpr int margin_top = 64;
constexpr int margin_right = 24;
constexpr int label_width = 36;  // of a pixel's number with its gap
constexpr int legend_line = 20;
constexpr int legend_outcome = 310;  // where a line of the legend says who is seen
constexpr std::size_t legend_lines = 10;

Rgba8 colour_of(std::uint32_t id) {
  return srgb_from_linear(id_colour(id));
}

Rgba8 with_alpha(Rgba8 colour, std::uint8_t alpha) {
  colour.a = alpha;
  return colour;
}

std::string outcome_text(const CoveringFragment& fragment) {
  switch (fragment.outcome) {
    case FragmentOutcome::seen:
      return "is seen";
    case FragmentOutcome::farther:
      return "is farther";
    case FragmentOutcome::higher_id:
      return "ties, but has the higher id";
    case FragmentOutcome::same_triangle:
      return "is the same triangle";
  }
  return {};
}

/// One drawing in the making: which pixels it shows and where they lie on the canvas.
class Sheet {
 public:
  Sheet(const PixelExplanation& pixel, const PixelDrawing& drawing, const Rect& whole)
      : pixel_(pixel),
        cell_(drawing.cell_size),
        shown_{pixel.x - drawing.radius, pixel.y - drawing.radius, 2 * drawing.radius + 1,
               2 * drawing.radius + 1},
        inside_(intersect(shown_, whole)),
        canvas_(std::max(margin_left + shown_.width * cell_ + margin_right, legend_width()),
                margin_top + shown_.height * cell_ + legend_height(), paper) {}

  const Rect& inside() const { return inside_; }

  void draw(const Picture& neighbours) {
    draw_cells(neighbours);
    for (std::size_t i = pixel_.fragments.size(); i-- > 0;) draw_outline(pixel_.fragments[i]);
    draw_centres(neighbours);
    draw_corners();
    draw_sought_centre();
    draw_margins();
    draw_legend();
  }

  Image<Rgba8> picture() const { return canvas_.picture(); }

 private:
  /// As wide as the longest line of the legend.
  int legend_width() const {
    int longest = 0;
    for (const CoveringFragment& fragment : pixel_.fragments)
      longest = std::max(longest, Canvas::text_width(outcome_text(fragment), 2));
    return margin_left + legend_outcome + longest + margin_right;
  }

  int legend_height() const {
    const std::size_t lines = std::min(pixel_.fragments.size(), legend_lines) + 1;
    return legend_line * static_cast<int>(lines + 1);
  }

  /// Canvas position of a position in the picture, pixels.
  glm::dvec2 at(double px, double py) const {
    return {margin_left + (px - shown_.left) * cell_, margin_top + (py - shown_.top) * cell_};
  }
  glm::dvec2 at(const SnappedVertex& v) const {
    return at(static_cast<double>(v.x) / subpixels, static_cast<double>(v.y) / subpixels);
  }

  void draw_cells(const Picture& neighbours) {
    canvas_.rectangle(margin_left, margin_top, shown_.width * cell_, shown_.height * cell_, grid);
    for (int y = inside_.top; y < inside_.bottom(); ++y) {
      for (int x = inside_.left; x < inside_.right(); ++x) {
        const int left = margin_left + (x - shown_.left) * cell_;
        const int top = margin_top + (y - shown_.top) * cell_;
        canvas_.rectangle(left, top, cell_ - 1, cell_ - 1, paper);
        const std::uint32_t id = neighbours.triangle_id.at(x - inside_.left, y - inside_.top);
        if (id != no_primitive)
          canvas_.rectangle(left, top, cell_ - 1, cell_ - 1, with_alpha(colour_of(id), 190));
      }
    }
  }

  void draw_outline(const CoveringFragment& fragment) {
    std::array<glm::dvec2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = at(fragment.triangle.vertices[i]);
    const bool is_seen = fragment.outcome == FragmentOutcome::seen;
    canvas_.outline(corners, is_seen ? 4.0 : 2.0, is_seen ? ink : faint);
    canvas_.outline(corners, is_seen ? 2.0 : 1.0, colour_of(fragment.primitive));
  }

  void draw_centres(const Picture& neighbours) {
    for (int y = inside_.top; y < inside_.bottom(); ++y) {
      for (int x = inside_.left; x < inside_.right(); ++x) {
        const bool is_background =
            neighbours.triangle_id.at(x - inside_.left, y - inside_.top) == no_primitive;
        canvas_.disc(at(x + 0.5, y + 0.5), std::min(2.5, 0.12 * cell_), is_background ? faint : ink);
      }
    }
  }

  void draw_sought_centre() {
    canvas_.disc(at(pixel_.x + 0.5, pixel_.y + 0.5), 3.0, sought);
    canvas_.ring(at(pixel_.x + 0.5, pixel_.y + 0.5), 9.0, 2.0, sought);
  }

  /// The seen piece's corners P0, P1, P2, as the text names them.
  void draw_corners() {
    if (pixel_.fragments.empty()) return;
    const ScreenTriangle& seen = pixel_.fragments[0].triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec2 corner = at(seen.vertices[i]);
      canvas_.disc(corner, 5.0, ink);
      canvas_.text(corner + glm::dvec2(8.0, -16.0), "P" + std::to_string(i), 2, ink);
    }
  }

  /// Paper over what stuck out, then the pixels' numbers.
  void draw_margins() {
    const int right = margin_left + shown_.width * cell_;
    const int bottom = margin_top + shown_.height * cell_;
    canvas_.rectangle(0, 0, canvas_.width(), margin_top, paper);
    canvas_.rectangle(0, bottom, canvas_.width(), canvas_.height() - bottom, paper);
    canvas_.rectangle(0, 0, margin_left, canvas_.height(), paper);
    canvas_.rectangle(right, 0, canvas_.width() - right, canvas_.height(), paper);
    const int step = (label_width + cell_ - 1) / cell_;
    for (int i = pixel_.x - shown_.left; i < shown_.width; i += step) draw_numbers(i);
    for (int i = pixel_.x - shown_.left - step; i >= 0; i -= step) draw_numbers(i);
  }

  /// Of the i-th column and row shown. The explained pixel is in the middle of both.
  void draw_numbers(int i) {
    const int x = shown_.left + i;
    if (x >= inside_.left && x < inside_.right())
      canvas_.text(at(x + 0.5, shown_.top) - glm::dvec2(0, 14), std::to_string(x), 1,
                   x == pixel_.x ? sought : faint, TextAnchor::middle);
    const int y = shown_.top + i;
    if (y >= inside_.top && y < inside_.bottom())
      canvas_.text(at(shown_.left, y + 0.5) - glm::dvec2(8, 3), std::to_string(y), 1,
                   y == pixel_.y ? sought : faint, TextAnchor::right);
  }

  void draw_legend() {
    const std::string title = "pixel " + std::to_string(pixel_.x) + "," + std::to_string(pixel_.y);
    canvas_.text({margin_left, 16}, title, 2, sought);
    double y = margin_top + shown_.height * cell_ + 12;
    if (pixel_.fragments.empty()) canvas_.text({margin_left, y}, "background", 2, ink);
    for (std::size_t i = 0; i < pixel_.fragments.size(); ++i, y += legend_line) {
      if (i == legend_lines) {
        const std::size_t more = pixel_.fragments.size() - legend_lines;
        canvas_.text({margin_left, y}, "and " + std::to_string(more) + " more", 2, ink);
        break;
      }
      const CoveringFragment& fragment = pixel_.fragments[i];
      canvas_.rectangle(margin_left, static_cast<int>(y) - 1, 16, 16, colour_of(fragment.primitive));
      canvas_.text({margin_left + 26, y}, std::to_string(fragment.primitive), 2, ink);
      canvas_.text({margin_left + 150, y}, "r=" + short_number(fragment.reversed_depth, 6), 2, ink);
      canvas_.text({margin_left + legend_outcome, y}, outcome_text(fragment), 2, ink);
    }
  }

  const PixelExplanation& pixel_;
  int cell_;
  Rect shown_;
  Rect inside_;
  Canvas canvas_;
};

}  // namespace

Image<Rgba8> draw_pixel(const PixelExplanation& pixel, const Scene& scene, const Camera& camera,
                        const RenderSettings& settings, const PixelDrawing& drawing) {
  const FloatingPointScope floating_point;
  VELUM_REQUIRE(
      drawing.radius >= 0 && drawing.radius <= 64 && drawing.cell_size >= 8 && drawing.cell_size <= 256,
      {"radius", drawing.radius}, {"cell_size", drawing.cell_size});
  RenderSettings around = settings;
  around.crop.reset();
  const Rect whole = requested_rect(around);
  check_pixel(whole, pixel.x, pixel.y);
  Sheet sheet(pixel, drawing, whole);
  around.crop = sheet.inside();
  around.shading = Shading::triangle_id;
  around.shader = nullptr;
  around.wireframe = false;
  around.layers = 1;
  sheet.draw(render(scene, camera, around));
  return sheet.picture();
}

}  // namespace velum
