#include "input.hpp"

#include <filesystem>

namespace velum_app {

velum::Scene read_scene(const std::string& input) {
  if (input.empty()) {
    throw velum::Error(velum::ErrorKind::read, "the file name is empty", "IN",
                       "give a mesh file, - for standard input, or builtin:NAME");
  }
  if (input != "-") return velum::load_scene(input);
  const std::vector<std::byte> bytes = velum::read_file("-");
  return velum::load_scene_from_memory(bytes, "standard input");
}

std::string stem_of(const std::string& input) {
  const std::string builtin = "builtin:";
  if (input == "-") return "stdin";
  const std::string stem = input.starts_with(builtin) ? input.substr(builtin.size())
                                                      : std::filesystem::path(input).stem().string();
  return stem.empty() ? "picture" : stem;
}

}  // namespace velum_app
