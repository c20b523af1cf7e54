#include "error.hpp"

namespace velum {
namespace {

std::string sentence(const std::string& problem, const std::string& where, const std::string& remedy) {
  std::string text = where.empty() ? problem : where + ": " + problem;
  if (!remedy.empty()) text += "; " + remedy;
  return text;
}

}  // namespace

Error::Error(ErrorKind kind, const std::string& problem, const std::string& where, const std::string& remedy)
    : std::runtime_error(sentence(problem, where, remedy)), kind_(kind) {}

}  // namespace velum
