#include "agreement_drawing.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "../base/contract.hpp"
#include "../image/visibility_buffer.hpp"
#include "canvas.hpp"

namespace velum {
namespace {

constexpr std::array<AgreementClass, agreement_count> classes{{
    {"same", "the same triangle, or the background", {96, 96, 96, 255}},
    {"edge", "as near to an edge as snapping moves it", {50, 160, 255, 255}},
    {"cut", "the same at the near or far plane", {255, 210, 0, 255}},
    {"tie", "depths equal within rounding", {30, 235, 80, 255}},
    {"unexplained", "a fault", {255, 30, 60, 255}},
}};

constexpr Rgba8 background{8, 10, 16, 255};
constexpr Rgba8 panel{28, 30, 36, 255};
constexpr Rgba8 ink{240, 240, 240, 255};
constexpr Rgba8 faint{170, 175, 185, 255};

constexpr int legend_line = 22;
constexpr int legend_height = 12 + agreement_count * legend_line + 6;
constexpr int least_width = 540;  // of the legend's longest line
constexpr int margin = 12;
constexpr int name_at = margin + 26;
constexpr int count_end = name_at + 240;
constexpr int meaning_at = count_end + 20;

/// The scene in dark grey, so that any class's colour stands out.
Rgba8 faint_grey(const Rgba8& colour) {
  const int grey = (54 * colour.r + 183 * colour.g + 19 * colour.b) / 256;
  const auto dim = static_cast<std::uint8_t>(34 + grey * 3 / 8);
  return {dim, dim, dim, 255};
}

/// One map in the making.
class Map {
 public:
  Map(const AgreementReport& report, const Picture& beneath)
      : report_(report),
        beneath_(beneath),
        width_(report.classes.width()),
        height_(report.classes.height()),
        step_(std::clamp(least_width / std::max(1, width_), 1, 16)),
        left_(std::max(0, least_width - width_ * step_) / 2),
        canvas_(std::max(least_width, width_ * step_), height_ * step_ + legend_height, panel) {}

  Image<Rgba8> draw() {
    draw_scene();
    for (const Agreement kind : {Agreement::edge, Agreement::cut, Agreement::tie}) draw_marks(kind, 3);
    draw_rings();
    draw_marks(Agreement::unexplained, 7);  // over the rings of their neighbours
    draw_legend();
    return canvas_.picture();
  }

 private:
  void draw_scene() {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const bool is_covered = beneath_.triangle_id.at(x, y) != no_primitive;
        canvas_.rectangle(left_ + x * step_, y * step_, step_, step_,
                          is_covered ? faint_grey(beneath_.colour.at(x, y)) : background);
      }
    }
  }

  template <class Draw>
  void for_each_pixel(Agreement kind, const Draw& draw) const {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        if (report_.classes.at(x, y) == static_cast<std::uint8_t>(kind)) draw(x, y);
      }
    }
  }

  /// Squares of at least `side` pixels, cut where they leave the map.
  void draw_marks(Agreement kind, int side) {
    const int size = std::max(step_, side);
    const int beyond = (size - step_) / 2;
    for_each_pixel(kind, [&](int x, int y) {
      const int from_x = std::max(0, x * step_ - beyond), from_y = std::max(0, y * step_ - beyond);
      const int to_x = std::min(width_ * step_, x * step_ - beyond + size);
      const int to_y = std::min(height_ * step_, y * step_ - beyond + size);
      canvas_.rectangle(left_ + from_x, from_y, to_x - from_x, to_y - from_y, agreement_class(kind).colour);
    });
  }

  void draw_rings() {
    for_each_pixel(Agreement::unexplained, [&](int x, int y) {
      canvas_.ring({left_ + (x + 0.5) * step_, (y + 0.5) * step_}, 9.0 + 0.5 * step_, 2.0, ink);
    });
  }

  void draw_legend() {
    const int top = height_ * step_;
    canvas_.rectangle(0, top, canvas_.width(), legend_height, panel);
    int y = top + 12;
    canvas_.text({margin, y},
                 std::to_string(report_.differences.size()) + " of " + std::to_string(report_.covered) +
                     " covered pixels differ",
                 2, ink);
    for (std::size_t i = 1; i < classes.size(); ++i) {
      y += legend_line;
      canvas_.rectangle(margin, y - 1, 16, 16, classes[i].colour);
      canvas_.text({name_at, y}, classes[i].name, 2, ink);
      canvas_.text({count_end, y}, std::to_string(report_.counts[i]), 2, ink, TextAnchor::right);
      canvas_.text({meaning_at, y + 4}, classes[i].meaning, 1, faint);
    }
  }

  const AgreementReport& report_;
  const Picture& beneath_;
  int width_, height_;
  int step_;  ///< side of a pixel on the map
  int left_;  ///< where the map begins on a canvas that is as wide as the legend
  Canvas canvas_;
};

}  // namespace

const AgreementClass& agreement_class(Agreement agreement) {
  return classes[static_cast<std::size_t>(agreement)];
}

Image<Rgba8> draw_agreement(const AgreementReport& report, const Picture& beneath) {
  VELUM_REQUIRE(beneath.colour.width() == report.classes.width() &&
                    beneath.colour.height() == report.classes.height() &&
                    beneath.triangle_id.width() == report.classes.width() &&
                    beneath.triangle_id.height() == report.classes.height(),
                {"width", beneath.colour.width()}, {"wanted", report.classes.width()});
  return Map(report, beneath).draw();
}

}  // namespace velum
