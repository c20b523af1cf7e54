#pragma once

#include <CLI/CLI.hpp>
#include <optional>
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
CLI::Option* add_accelerator_option(CLI::App& parser, std::string& accelerator);

/// `--visibility` and what tells how it works, as given.
struct VisibilityOptions {
  std::string method = "zbuffer";
  std::string accelerator = "bvh";
  std::optional<std::string> hierarchy;
  std::string z_interpolation = "plane";
  std::string depth_format = "reversed";
  std::string isa = "best";
  ClipOption clip;
  int threads = 0;
  bool is_analytic = false;            ///< --analytic: bodies by their equations
  std::optional<std::string> kd_file;  ///< --kd-file

  /// @pre called for one parser, which lives as long
  void add_to(CLI::App& parser);
  /// @throws velum::Error (usage) for what does not go together
  void apply_to(velum::RenderSettings& settings) const;
  /// Reads the scene's kd-trees from --kd-file, or builds and writes them where there is no such file.
  /// @throws velum::Error (read) for a file that is damaged or of another scene, velum::Error (write)
  void prepare_trees(const velum::Scene& scene, velum::RenderSettings& settings) const;

 private:
  void check() const;

  const CLI::Option* accelerator_option_ = nullptr;
};

}  // namespace velum_app
