#pragma once

#include <string>

namespace velum_plots {

/// A place on the page, pixels, y down.
struct Point {
  double x;
  double y;
};

enum class Anchor { start, middle, end };

/// How text looks.
struct TextStyle {
  double size = 14.0;
  Anchor anchor = Anchor::start;
  const char* colour = "#222222";
  bool is_bold = false;
};

/// A picture made of a few kinds of marks, written as SVG.
class Svg {
 public:
  Svg(double width, double height);
  void rectangle(Point corner, double width, double height, const char* colour);
  void line(Point from, Point to, const char* colour, double width = 1.0, const char* dashes = "");
  void dot(Point centre, double radius, const char* fill, const char* outline);
  void text(Point base, const std::string& words, const TextStyle& style = {});
  /// The whole file.
  std::string done() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace velum_plots
