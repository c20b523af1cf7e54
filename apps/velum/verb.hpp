#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace velum_app {

/// The exit codes of the program (docs/conventions.md). Nothing else is returned on purpose.
enum ExitCode : int {
  exit_ok = 0,
  exit_blank = 1,      ///< rendered, but nothing is to be seen
  exit_different = 1,  ///< velum diff: the pictures differ by more than the limits allow
  exit_usage = 2,
  exit_cannot_read = 3,
  exit_cannot_write = 4,
  exit_internal = 70,  ///< a fault of the program itself
};

/// One verb of the command line: its parser and what it does, which gives the exit code.
struct Verb {
  CLI::App* parser;
  std::function<int()> run;
};

Verb add_render(CLI::App& program);
Verb add_matrix(CLI::App& program);
Verb add_info(CLI::App& program);
Verb add_projections(CLI::App& program);
Verb add_views(CLI::App& program);
Verb add_pixel(CLI::App& program);
Verb add_clip_trace(CLI::App& program);
Verb add_diff(CLI::App& program);
Verb add_agree(CLI::App& program);
Verb add_pyramid(CLI::App& program);

}  // namespace velum_app
