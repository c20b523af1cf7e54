#pragma once

#include <CLI/CLI.hpp>
#include <velum/velum.hpp>

namespace velum_app {

/// `--line-width` and `--point-size`, as given, pixels.
struct LineOptions {
  float line_width = 1.0f;
  float point_size = 3.0f;

  void add_to(CLI::App& parser);
  void apply_to(velum::RenderSettings& settings) const;
};

}  // namespace velum_app
