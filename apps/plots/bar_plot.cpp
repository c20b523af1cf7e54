#include "bar_plot.hpp"

#include <algorithm>
#include <cmath>

#include "svg.hpp"
#include "table.hpp"

namespace velum_plots {
namespace {

constexpr double left = 250.0, width = 560.0, right = 110.0, top = 100.0, bottom = 40.0;
constexpr double thickness = 16.0, gap = 14.0;
constexpr const char* colours[] = {"#2f6f9f", "#c23b22", "#5b8c3a", "#7a5195", "#8c6d31"};
constexpr const char* grid_colour = "#dddddd";
constexpr const char* soft_colour = "#666666";

double largest(const BarPlot& plot) {
  double most = 0.0;
  for (const Bars& line : plot.lines) {
    for (const double value : line.values) most = std::max(most, value);
  }
  return most > 0.0 ? most : 1.0;
}

/// 1, 2 or 5 times a power of ten: about five of them up to `most`.
double step_for(double most) {
  const double decade = std::pow(10.0, std::floor(std::log10(most / 5.0)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (most / (decade * factor) <= 6.0) return decade * factor;
  }
  return decade * 10.0;
}

void draw_scale(Svg& svg, double most, double height, const std::string& unit) {
  const double step = step_for(most);
  for (int i = 0; i * step <= most; ++i) {
    const double x = left + width * (i * step) / most;
    svg.line({x, top - 6.0}, {x, height - bottom + 4.0}, grid_colour);
    svg.text({x, height - bottom + 20.0}, tick_label(i * step), {12.0, Anchor::middle, soft_colour});
  }
  svg.text({left + width + 12.0, height - bottom + 20.0}, unit, {12.0, Anchor::start, soft_colour});
}

void draw_names(Svg& svg, const BarPlot& plot) {
  double x = left;
  for (std::size_t i = 0; i < plot.value_names.size(); ++i) {
    const char* colour = colours[i % std::size(colours)];
    svg.rectangle({x, 70.0}, 12.0, 12.0, colour);
    svg.text({x + 18.0, 81.0}, plot.value_names[i], {13.0, Anchor::start, colour, true});
    x += 44.0 + 8.0 * static_cast<double>(plot.value_names[i].size());
  }
}

}  // namespace

std::string svg_of(const BarPlot& plot) {
  const double bars = static_cast<double>(plot.value_names.size()) * thickness;
  const double height = top + static_cast<double>(plot.lines.size()) * (bars + gap) + bottom;
  const double most = largest(plot);
  Svg svg(left + width + right, height);
  svg.text({24.0, 32.0}, plot.title, {19.0, Anchor::start, "#222222", true});
  svg.text({24.0, 52.0}, plot.subtitle, {12.0, Anchor::start, soft_colour});
  draw_scale(svg, most, height, plot.unit);
  draw_names(svg, plot);
  double y = top;
  for (const Bars& line : plot.lines) {
    svg.text({left - 12.0, y + bars / 2.0 + 5.0}, line.name, {14.0, Anchor::end, "#222222"});
    for (std::size_t i = 0; i < line.values.size(); ++i) {
      const double length = std::max(1.0, width * line.values[i] / most);
      const double at = y + static_cast<double>(i) * thickness;
      svg.rectangle({left, at}, length, thickness - 2.0, colours[i % std::size(colours)]);
      svg.text({left + length + 6.0, at + 12.0}, short_figure(line.values[i]),
               {12.0, Anchor::start, soft_colour});
    }
    y += bars + gap;
  }
  return svg.done();
}

}  // namespace velum_plots
