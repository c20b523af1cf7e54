#include "hash_file.hpp"

#include <sstream>
#include <velum/velum.hpp>

namespace golden {

std::map<std::string, std::string> read_hashes(const std::filesystem::path& path) {
  const std::vector<std::byte> bytes = velum::read_file(path);
  std::istringstream text(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  std::map<std::string, std::string> hashes;
  for (std::string line; std::getline(text, line);) {
    const std::size_t space = line.find(' ');
    if (space == std::string::npos) {
      throw velum::Error(velum::ErrorKind::read, "no hashes behind \"" + line + "\"", path.string(),
                         "./run goldens writes the file");
    }
    hashes[line.substr(0, space)] = line.substr(space + 1);
  }
  return hashes;
}

std::string differing_buffers(const std::string& expected, const std::string& actual) {
  std::istringstream from(expected);
  std::istringstream to(actual);
  std::string names;
  for (std::string a, b; to >> b; a.clear()) {
    if (from >> a; a == b) continue;
    names += (names.empty() ? "" : ", ") + b.substr(0, b.find('='));
  }
  return names;
}

}  // namespace golden
