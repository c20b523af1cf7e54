#include "input.hpp"

#include <filesystem>

namespace velum_app {

velum::Scene read_scene(const std::string& input) {
  if (input != "-") return velum::load_scene(input);
  const std::vector<std::byte> bytes = velum::read_file("-");
  return velum::load_scene_from_memory(bytes, "standard input");
}

std::string stem_of(const std::string& input) {
  const std::string builtin = "builtin:";
  if (input == "-") return "stdin";
  if (input.starts_with(builtin)) return input.substr(builtin.size());
  const std::string stem = std::filesystem::path(input).stem().string();
  return stem.empty() ? "picture" : stem;
}

}  // namespace velum_app
