#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <velum/velum.hpp>

#include "parse_values.hpp"

namespace velum_app {

/// The camera options as they stand on the command line, of `render` and `matrix` alike.
struct CameraOptions {
  std::string projection = "perspective";
  std::optional<std::string> eye, target, up, fov, hfov, near, far;
  std::string world_up = "y";
  std::string size = "800x600";

  void add_to(CLI::App& parser);
};

/// What the options mean.
struct View {
  velum::Projection projection;
  velum::FrameOptions framing;
  Size size;

  velum::UpAxis up_axis() const { return framing.z_up ? velum::UpAxis::z : velum::UpAxis::y; }
};

/// @throws velum::Error (usage) naming the option that cannot be used
View view_from(const CameraOptions& options);

}  // namespace velum_app
