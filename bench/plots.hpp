#pragma once

#include <plots/log_plot.hpp>
#include <plots/svg.hpp>
#include <plots/table.hpp>

namespace velum_bench {

using namespace velum_plots;

}  // namespace velum_bench
