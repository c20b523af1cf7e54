#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string_view>

#include "../image/colour.hpp"
#include "../image/image.hpp"

namespace velum {

/// How letters sit at the position given for them.
enum class TextAnchor { left, middle, right };

/// Anti-aliased lines, discs, filled polygons and small letters, for diagrams. Positions are in pixels, y
/// down, (0,0) the top left corner, centres at +0.5; all may lie outside. Colours are sRGB with straight
/// alpha; what is drawn later lies over what was drawn before, blended in linear light.
class Canvas {
 public:
  /// @pre width ≥ 0, height ≥ 0
  Canvas(int width, int height, const Rgba8& background);

  int width() const { return pixels_.width(); }
  int height() const { return pixels_.height(); }

  /// A line with round ends, `thickness` pixels wide. Nothing where an end is not finite.
  void line(const glm::dvec2& a, const glm::dvec2& b, double thickness, const Rgba8& colour);
  /// Dashes of `dash` pixels and gaps as long, beginning with a dash at a.
  void dashed_line(const glm::dvec2& a, const glm::dvec2& b, double thickness, double dash,
                   const Rgba8& colour);
  /// The closed line through all corners.
  void outline(std::span<const glm::dvec2> corners, double thickness, const Rgba8& colour);
  void disc(const glm::dvec2& centre, double radius, const Rgba8& colour);
  void ring(const glm::dvec2& centre, double radius, double thickness, const Rgba8& colour);
  /// The inside by the even-odd rule, with 4×4 samples in each pixel.
  void polygon(std::span<const glm::dvec2> corners, const Rgba8& colour);
  /// An axis-parallel rectangle on whole pixels.
  void rectangle(int left, int top, int width, int height, const Rgba8& colour);
  /// ASCII text in letters of 5×7 dots, each dot `scale` pixels wide; `at` is the left end, middle or right
  /// end of the letters' top. Rounded to whole pixels. @pre scale ≥ 1
  void text(const glm::dvec2& at, std::string_view text, int scale, const Rgba8& colour,
            TextAnchor anchor = TextAnchor::left);

  /// Width of a text in pixels; its height is 7·scale.
  static int text_width(std::string_view text, int scale);

  /// The picture so far.
  Image<Rgba8> picture() const;

 private:
  struct Bounds {
    int left, top, right, bottom;
  };
  /// The pixels that a shape between two corners can touch.
  Bounds bounds_of(const glm::dvec2& low, const glm::dvec2& high) const;
  void blend(int x, int y, const glm::vec4& colour, double coverage);
  void letter(int left, int top, char character, int scale, const Rgba8& colour);

  Image<glm::vec4> pixels_;  ///< linear, premultiplied
};

}  // namespace velum
