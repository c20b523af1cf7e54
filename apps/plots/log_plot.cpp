#include "log_plot.hpp"

#include <algorithm>
#include <cmath>

#include "table.hpp"

namespace velum_plots {
namespace {

constexpr double left = 84.0, right = 320.0, top = 104.0, bottom = 62.0, width = 600.0, height = 420.0;
constexpr const char* colours[] = {"#2f6f9f", "#c23b22", "#5b8c3a", "#7a5195", "#8c6d31"};
constexpr const char* grid_colour = "#dddddd";
constexpr const char* soft_colour = "#666666";

struct Axis {
  double least = 1e300, most = 0.0;

  void include(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
  /// Leaves room around what is included.
  void widen() {
    least /= 1.5;
    most *= 1.5;
  }
  double share(double value) const { return std::log(value / least) / std::log(most / least); }
};

struct Frame {
  Axis x, y;
  Point place(const Point& p) const {
    return {left + width * x.share(p.x), top + height * (1.0 - y.share(p.y))};
  }
};

Frame frame_of(const LogPlot& plot) {
  Frame frame;
  for (const Series& series : plot.series) {
    for (const Point& p : series.points) {
      frame.x.include(p.x);
      frame.y.include(p.y);
    }
  }
  frame.x.widen();
  frame.y.widen();
  return frame;
}

/// Powers of ten on the axis; with 2 and 5 between them where it spans few.
std::vector<double> ticks(const Axis& axis) {
  const bool is_short = axis.most / axis.least < 3e3;
  std::vector<double> values;
  for (double decade = 1e-6; decade < 1e12; decade *= 10.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = decade * factor;
      if (value >= axis.least && value <= axis.most && (is_short || factor == 1.0)) values.push_back(value);
    }
  }
  return values;
}

void draw_axes(Svg& svg, const Frame& frame, const LogPlot& plot) {
  for (const double value : ticks(frame.x)) {
    const double x = frame.place({value, frame.y.least}).x;
    svg.line({x, top}, {x, top + height}, grid_colour);
    svg.text({x, top + height + 20.0}, tick_label(value), {12.0, Anchor::middle, soft_colour});
  }
  for (const double value : ticks(frame.y)) {
    const double y = frame.place({frame.x.least, value}).y;
    svg.line({left, y}, {left + width, y}, grid_colour);
    svg.text({left - 10.0, y + 4.0}, tick_label(value), {12.0, Anchor::end, soft_colour});
  }
  svg.line({left, top + height}, {left + width, top + height}, soft_colour);
  svg.line({left, top}, {left, top + height}, soft_colour);
  svg.text({left + width / 2.0, top + height + 44.0}, plot.x_name, {13.0, Anchor::middle, "#222222"});
  svg.text({left - 60.0, top - 14.0}, plot.y_name, {13.0, Anchor::start, "#222222"});
}

void draw_series(Svg& svg, const Frame& frame, const Series& series, const char* colour) {
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const Point here = frame.place(series.points[i]);
    if (i > 0) svg.line(frame.place(series.points[i - 1]), here, colour, 2.0);
    svg.dot(here, 3.5, "#ffffff", colour);
  }
}

/// Names beside the last points, pushed apart where they would stand over each other.
void draw_names(Svg& svg, const Frame& frame, const LogPlot& plot) {
  struct Name {
    const Series* series;
    const char* colour;
    double y;
  };
  std::vector<Name> names;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    names.push_back({&series, colours[i % std::size(colours)], frame.place(series.points.back()).y});
  }
  std::sort(names.begin(), names.end(), [](const Name& a, const Name& b) { return a.y < b.y; });
  double free_from = 0.0;
  for (const Name& name : names) {
    const double y = std::max(name.y, free_from);
    svg.text({left + width + 14.0, y}, name.series->name, {14.0, Anchor::start, name.colour, true});
    svg.text({left + width + 14.0, y + 16.0},
             "exponent " + fixed(name.series->exponent(), 2) + ", larger half " +
                 fixed(name.series->exponent_of_large(), 2),
             {12.0, Anchor::start, name.colour});
    free_from = y + 40.0;
  }
}

}  // namespace

double Series::exponent(std::size_t first) const {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = first; i < points.size(); ++i) {
    const double x = std::log(points[i].x), y = std::log(points[i].y);
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::string svg_of(const LogPlot& plot) {
  Svg svg(left + width + right, top + height + bottom);
  svg.text({24.0, 32.0}, plot.title, {19.0, Anchor::start, "#222222", true});
  svg.text({24.0, 52.0}, plot.subtitle, {12.0, Anchor::start, soft_colour});
  const Frame frame = frame_of(plot);
  draw_axes(svg, frame, plot);
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    draw_series(svg, frame, plot.series[i], colours[i % std::size(colours)]);
  draw_names(svg, frame, plot);
  return svg.done();
}

}  // namespace velum_plots
