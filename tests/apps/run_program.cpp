#include "run_program.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace fs = std::filesystem;

namespace {

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

}  // namespace

Workplace::Workplace() {
  std::string name = (fs::temp_directory_path() / "velum-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
  folder_ = name;
}

Workplace::~Workplace() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  fs::remove(folder_.string() + ".out", ignored);
  fs::remove(folder_.string() + ".err", ignored);
}

Outcome Workplace::velum(const std::string& arguments, const std::string& input) const {
  const fs::path out = folder_.string() + ".out";
  const fs::path err = folder_.string() + ".err";
  const std::string command = "cd " + quoted(folder_) + " && " + quoted(VELUM_PROGRAM) + " " + arguments +
                              " <" + (input.empty() ? std::string("/dev/null") : quoted(path(input))) + " >" +
                              quoted(out) + " 2>" + quoted(err);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(out), content(err)};
}

void Workplace::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
}

std::string Workplace::read(const std::string& name) const {
  return content(path(name));
}

std::vector<std::string> Workplace::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}
