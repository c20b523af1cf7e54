#include "svg.hpp"

#include "table.hpp"

namespace velum_plots {
namespace {

std::string number(double value) {
  return "\"" + fixed(value, 1) + "\"";
}

const char* name_of(Anchor anchor) {
  return anchor == Anchor::start ? "start" : anchor == Anchor::middle ? "middle" : "end";
}

}  // namespace

Svg::Svg(double width, double height)
    : body_("<svg xmlns=\"http://www.w3.org/2000/svg\" width=" + number(width) + " height=" + number(height) +
            " font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n") {
  rectangle({0, 0}, width, height, "#ffffff");
}

void Svg::rectangle(Point corner, double width, double height, const char* colour) {
  body_ += "<rect x=" + number(corner.x) + " y=" + number(corner.y) + " width=" + number(width) +
           " height=" + number(height) + " fill=\"" + colour + "\" stroke=\"none\"/>\n";
}

void Svg::line(Point from, Point to, const char* colour, double width, const char* dashes) {
  body_ += "<line x1=" + number(from.x) + " y1=" + number(from.y) + " x2=" + number(to.x) +
           " y2=" + number(to.y) + " stroke=\"" + colour + "\" stroke-width=" + number(width);
  if (dashes[0] != '\0') body_ += std::string(" stroke-dasharray=\"") + dashes + "\"";
  body_ += "/>\n";
}

void Svg::dot(Point centre, double radius, const char* fill, const char* outline) {
  body_ += "<circle cx=" + number(centre.x) + " cy=" + number(centre.y) + " r=" + number(radius) +
           " fill=\"" + fill + "\" stroke=\"" + outline + "\" stroke-width=\"2\"/>\n";
}

void Svg::text(Point base, const std::string& words, const TextStyle& style) {
  body_ += "<text x=" + number(base.x) + " y=" + number(base.y) + " font-size=" + number(style.size) +
           " text-anchor=\"" + name_of(style.anchor) + "\" stroke=\"none\" fill=\"" + style.colour + "\"" +
           (style.is_bold ? " font-weight=\"bold\"" : "") + ">" + escaped(words) + "</text>\n";
}

}  // namespace velum_plots
