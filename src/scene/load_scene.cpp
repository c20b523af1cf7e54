#include "load_scene.hpp"

#include "../base/floating_point.hpp"
#include "../image/files.hpp"
#include "builtin.hpp"
#include "checkerboard.hpp"
#include "file_format.hpp"
#include "load_textures.hpp"
#include "obj_reader.hpp"
#include "ply_reader.hpp"
#include "stl_reader.hpp"

namespace velum {

Scene load_scene(const std::string& path, const LoadOptions& options) {
  const FloatingPointScope floating_point;
  constexpr std::string_view builtin = "builtin:";
  if (path.substr(0, builtin.size()) == builtin) {
    const std::string_view shape = std::string_view(path).substr(builtin.size());
    if (shape == "checkerboard") return checkerboard_scene();
    Scene scene;
    scene.add(builtin_shape(shape));
    return scene;
  }
  const std::vector<std::byte> bytes = read_file(path);
  if (path == "-") return load_scene_from_memory(bytes, "standard input", {}, options);
  const std::filesystem::path directory = std::filesystem::path(path).parent_path();
  return load_scene_from_memory(bytes, path, directory.empty() ? "." : directory, options);
}

Scene load_scene_from_memory(std::span<const std::byte> bytes, const std::string& name,
                             const std::filesystem::path& directory, const LoadOptions& options) {
  const FloatingPointScope scope;  // a caller's rounding mode or flush-to-zero changes no coordinate
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  switch (format_of(bytes, name)) {
    case FileFormat::ascii_stl:
      return read_ascii_stl(text, name, options);
    case FileFormat::binary_stl:
      return read_binary_stl(bytes, name, options);
    case FileFormat::ply:
      return read_ply(bytes, name, options);
    case FileFormat::obj:
      break;
  }
  Scene scene = read_obj(text, name, directory, options);
  load_textures(scene);
  return scene;
}

}  // namespace velum
