#pragma once

#include <string>
#include <vector>

namespace velum_plots {

/// One line of bars: a name and a value for each of BarPlot::value_names.
struct Bars {
  std::string name;
  std::vector<double> values;  ///< ≥ 0
};

struct BarPlot {
  std::string title;
  std::string subtitle;
  std::string unit;
  std::vector<std::string> value_names;  ///< what the bars of a line are, 1 … 5
  std::vector<Bars> lines;
};

/// Bars from left to right on one linear scale from 0, those of a line below each other. SVG.
std::string svg_of(const BarPlot& plot);

}  // namespace velum_plots
