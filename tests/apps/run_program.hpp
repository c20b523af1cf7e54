#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What a run of the program left behind.
struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// An empty folder of its own for each test, removed at the end; the program runs in it.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  /// Runs `velum ARGUMENTS` by the shell, with standard input from `input` if that is not empty.
  Outcome velum(const std::string& arguments, const std::string& input = {}) const;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  /// The names of all files, sorted; hidden ones too.
  std::vector<std::string> files() const;

 private:
  std::filesystem::path folder_;
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
