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
};

/// The names of the benchmark scenes, in the order in which they are measured.
std::vector<std::string> scene_names();

/// Makes one of them from the meshes and cameras in `data`; none where the mesh is not there.
/// @throws velum::Error for a name that does not exist, or a file that cannot be read
std::optional<BenchScene> make_scene(const std::string& name, const std::filesystem::path& data);

}  // namespace velum_bench
