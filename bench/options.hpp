#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "measure.hpp"

namespace velum_bench {

/// What the program was asked to do.
struct Options {
  MeasureOptions measure;
  std::vector<std::string> scenes;
  std::vector<std::string> modes;  ///< empty: each scene's default
  std::filesystem::path out = "out/bench";
  bool is_check = false;
  bool is_growth = false;
  bool is_limits = false;
  bool is_rays = false;
  bool is_memory_here = false;  ///< the child of number_from_child()
  bool is_cpu_time = false;
  bool is_markdown = false;
  bool is_alone = false;  ///< without llvmpipe
};

/// Reads the command line. @return the options, or the exit code where nothing is left to do (--help, misuse)
struct ParsedOptions {
  std::optional<Options> options;
  int exit_code = 0;
};
ParsedOptions parse_options(int argc, char** argv);

}  // namespace velum_bench
