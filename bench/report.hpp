#pragma once

#include <string>
#include <vector>

#include "measure.hpp"
#include "plots.hpp"

namespace velum_bench {

/// The rows as a table for people.
Table table_of(const std::vector<Row>& rows);

/// The rows with every figure, for programs.
std::string csv_of(const std::vector<Row>& rows);

/// A bar chart, SVG: how many times faster than llvmpipe, with what was wanted and hoped for; velum's
/// milliseconds where there is no llvmpipe.
std::string bar_chart_of(const std::vector<Row>& rows, const std::string& subtitle);

}  // namespace velum_bench
