#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>
#include <velum/velum.hpp>

namespace velum_bench {

/// A scene and the camera it is measured with.
struct BenchScene {
  std::string name;
  velum::Scene scene;
  velum::Camera camera;
  int width = 1920;
  int height = 1080;

  double aspect() const { return static_cast<double>(width) / height; }
  double pixels() const { return static_cast<double>(width) * height; }
};

/// The names of all scenes, in the order in which they are measured; "builtin-…" are made of built-in shapes
/// and need no file.
std::vector<std::string> scene_names();

/// Those that are measured unless others are asked for: all whose files are in `data`; where it holds none,
/// the built-in ones in their place.
std::vector<std::string> default_scene_names(const std::filesystem::path& data);

/// Makes one of them from the meshes and cameras in `data`; none where its files are not there.
/// @throws velum::Error for a name that does not exist, or a file that cannot be read
std::optional<BenchScene> make_scene(const std::string& name, const std::filesystem::path& data);

}  // namespace velum_bench
