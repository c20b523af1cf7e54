#include <algorithm>
#include <cmath>

#include "goals.hpp"
#include "plots.hpp"
#include "report.hpp"

namespace velum_bench {
namespace {

constexpr double left = 210.0, bars = 640.0, notes = 250.0;
constexpr double top = 92.0, step = 46.0, thickness = 26.0, bottom = 64.0;
constexpr const char* bar_colour = "#2f6f9f";
constexpr const char* fail_colour = "#b8b8b8";
constexpr const char* wanted_colour = "#c23b22";
constexpr const char* grid_colour = "#dddddd";
constexpr const char* soft_colour = "#666666";

/// From figures to places on the page: logarithmic, since ratios of 5 and of 200 stand side by side.
struct Scale {
  double least, most;
  double x(double value) const {
    return left + bars * std::clamp(std::log(value / least) / std::log(most / least), 0.0, 1.0);
  }
};

double figure_of(const Row& row) {
  return row.ratio().value_or(row.velum.median);
}

Scale scale_for(const std::vector<Row>& rows, bool has_ratios) {
  Scale scale{1.0, 10.0};
  for (const Row& row : rows) {
    scale.least = std::min(scale.least, figure_of(row));
    scale.most = std::max(scale.most, figure_of(row));
    if (const auto goal = ratio_goal(row.scene); goal && has_ratios)
      scale.most = std::max(scale.most, goal->hoped);
  }
  scale.most *= 1.15;
  return scale;
}

void draw_axis(Svg& svg, const Scale& scale, double height, const char* unit) {
  for (double decade = 1e-3; decade < 1e6; decade *= 10.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = decade * factor;
      if (value < scale.least * 0.999 || value > scale.most) continue;
      const double x = scale.x(value);
      svg.line({x, top - 8.0}, {x, height - bottom + 4.0}, grid_colour);
      svg.text({x, height - bottom + 22.0}, tick_label(value) + unit, {12.0, Anchor::middle, soft_colour});
    }
  }
}

std::string note_of(const Row& row) {
  std::string note = short_figure(row.velum.median) + " ms";
  if (row.llvmpipe) note += " against " + short_figure(row.llvmpipe->median) + " ms";
  return note;
}

void draw_bar(Svg& svg, const Scale& scale, const Row& row, double y, bool has_ratios) {
  const double figure = figure_of(row), end = scale.x(figure), middle = y + thickness / 2.0;
  svg.text({left - 14.0, middle}, row.scene, {15.0, Anchor::end, "#222222", true});
  svg.text({left - 14.0, middle + 15.0}, row.mode, {11.0, Anchor::end, soft_colour});
  svg.rectangle({left, y}, std::max(end - left, 1.0), thickness, row.agrees() ? bar_colour : fail_colour);
  const std::string label = short_figure(figure) + (has_ratios ? "×" : " ms");
  const bool is_inside = end - left > 70.0;
  svg.text({is_inside ? left + 10.0 : end + 8.0, middle + 5.0}, label,
           {15.0, Anchor::start, is_inside ? "#ffffff" : "#222222", true});
  svg.text({left + bars + 16.0, middle + 5.0}, note_of(row), {13.0, Anchor::start, soft_colour});
  const auto goal = ratio_goal(row.scene);
  if (!goal || !has_ratios) return;
  const double wanted = scale.x(goal->wanted), hoped = scale.x(goal->hoped);
  svg.line({wanted, y - 5.0}, {wanted, y + thickness + 5.0}, wanted_colour, 3.0);
  svg.line({hoped, y - 5.0}, {hoped, y + thickness + 5.0}, wanted_colour, 2.0, "3 3");
}

}  // namespace

std::string bar_chart_of(const std::vector<Row>& rows, const std::string& subtitle) {
  const bool has_ratios =
      !rows.empty() && std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.ratio(); });
  const double height = top + step * static_cast<double>(rows.size()) + bottom;
  Svg svg(left + bars + notes, height);
  svg.text({24.0, 34.0},
           has_ratios ? "How many times faster than llvmpipe a frame is" : "Milliseconds per frame",
           {20.0, Anchor::start, "#222222", true});
  svg.text({24.0, 58.0}, subtitle, {13.0, Anchor::start, soft_colour});
  const Scale scale = scale_for(rows, has_ratios);
  draw_axis(svg, scale, height, has_ratios ? "×" : "");
  double y = top;
  for (const Row& row : rows) {
    draw_bar(svg, scale, row, y, has_ratios);
    y += step;
  }
  svg.text({left, height - 14.0},
           has_ratios ? "Logarithmic scale. Red: what was wanted; dashed: what was hoped for."
                      : "Logarithmic scale.",
           {12.0, Anchor::start, soft_colour});
  return svg.done();
}

}  // namespace velum_bench
