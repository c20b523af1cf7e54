#include "builtin_parameters.hpp"

#include <charconv>
#include <string>

#include "../base/error.hpp"

namespace velum::shapes {
namespace {

constexpr std::int64_t k_most_triangles = std::int64_t{1} << 26;

[[noreturn]] void refuse(const char* shape, const std::string& problem, const std::string& remedy) {
  throw Error(ErrorKind::usage, problem, std::string("builtin:") + shape, remedy);
}

/// The shortest text that reads back as the value, whatever the locale.
std::string text(float value) {
  char characters[32];
  const auto result = std::to_chars(characters, characters + sizeof characters, value);
  return {characters, result.ptr};
}

}  // namespace

void require_length(const char* shape, const char* parameter, float value) {
  if (value >= 1e-15f && value <= 1e15f) return;  // false for NaN
  refuse(shape, std::string(parameter) + " is " + text(value), "give a length from 1e-15 to 1e15");
}

void require_below(const char* shape, const char* parameter, float value, const char* other,
                   float other_value) {
  if (value < other_value) return;
  refuse(shape, std::string(parameter) + " is " + text(value),
         std::string("it must be below ") + other + ", which is " + text(other_value));
}

void require_count(const char* shape, const char* parameter, int value, int lowest, int highest) {
  if (lowest <= value && value <= highest) return;
  refuse(shape, std::string(parameter) + " is " + std::to_string(value),
         "give a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
}

void require_triangles(const char* shape, std::int64_t triangles) {
  if (triangles <= k_most_triangles) return;
  refuse(shape, "these numbers ask for " + std::to_string(triangles) + " triangles",
         "at most " + std::to_string(k_most_triangles) + " are made; give smaller ones");
}

}  // namespace velum::shapes
