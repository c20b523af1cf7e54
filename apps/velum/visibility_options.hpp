#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <velum/velum.hpp>

namespace velum_app {

/// `--clip` as given.
struct ClipOption {
  std::string policy = "guard";

  void add_to(CLI::App& parser);
  void apply_to(velum::RenderSettings& settings) const;
};

/// `--accelerator` alone. @param accelerator  as given
void add_accelerator_option(CLI::App& parser, std::string& accelerator);

/// `--visibility` and what tells how it works, as given.
struct VisibilityOptions {
  std::string method = "zbuffer";
  std::string accelerator = "bvh";
  std::string hierarchy = "both";
  std::string z_interpolation = "plane";
  std::string depth_format = "reversed";
  std::string isa = "best";
  ClipOption clip;
  int threads = 0;

  void add_to(CLI::App& parser);
  void apply_to(velum::RenderSettings& settings) const;
};

}  // namespace velum_app
