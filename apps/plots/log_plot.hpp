#pragma once

#include <string>
#include <vector>

#include "svg.hpp"

namespace velum_plots {

/// Measured points that belong together; x and y > 0, x ascending; at least two.
struct Series {
  std::string name;
  std::vector<Point> points;

  /// The exponent e of y = c·x^e, fitted by least squares of the logarithms over the points from index
  /// `first` on. @pre two of them at least
  double exponent(std::size_t first = 0) const;
  /// Over the larger half, where costs that do not grow no longer count.
  double exponent_of_large() const { return exponent(points.size() / 2); }
};

struct LogPlot {
  std::string title;
  std::string subtitle;
  std::string x_name;
  std::string y_name;
  std::vector<Series> series;
};

/// Both axes logarithmic: a power law is a straight line, its exponent the slope. SVG.
std::string svg_of(const LogPlot& plot);

}  // namespace velum_plots
