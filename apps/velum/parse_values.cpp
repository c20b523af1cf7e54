#include "parse_values.hpp"

#include <charconv>
#include <cmath>
#include <vector>

namespace velum_app {
namespace {

using velum::Error;
using velum::ErrorKind;

[[noreturn]] void not_understood(std::string_view text, const std::string& option, const char* expected) {
  throw Error(ErrorKind::usage, "cannot understand \"" + std::string(text) + "\"", option,
              std::string("give ") + expected);
}

/// The whole text as a number of type T; false if any of it is left over.
template <typename T, typename... Form>
bool parse_whole(std::string_view text, T& value, Form... form) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value, form...);
  return code == std::errc{} && end == text.data() + text.size();
}

bool parse_finite(std::string_view text, double& value) {
  return parse_whole(text, value) && std::isfinite(value);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace

double number_from(std::string_view text, const std::string& option) {
  double value = 0.0;
  if (!parse_finite(text, value)) not_understood(text, option, "a finite number such as 2.5");
  return value;
}

glm::dvec3 vector_from(std::string_view text, const std::string& option) {
  const auto parts = split(text, ',');
  glm::dvec3 value{0.0};
  if (parts.size() != 3 || !parse_finite(parts[0], value.x) || !parse_finite(parts[1], value.y) ||
      !parse_finite(parts[2], value.z)) {
    not_understood(text, option, "three numbers x,y,z without spaces, such as 1,2.5,-3");
  }
  return value;
}

double opening_angle_from(std::string_view text, const std::string& option) {
  double degrees = 0.0;
  if (!parse_finite(text, degrees) || degrees <= 0.0 || degrees >= 180.0) {
    not_understood(text, option, "an angle in degrees between 0 and 180, such as 40");
  }
  return velum::radians(degrees);
}

Size size_from(std::string_view text, const std::string& option) {
  const auto parts = split(text, 'x');
  Size size{0, 0};
  const auto in_range = [](int value) { return value >= 1 && value <= 32768; };
  if (parts.size() != 2 || !parse_whole(parts[0], size.width) || !parse_whole(parts[1], size.height) ||
      !in_range(size.width) || !in_range(size.height)) {
    not_understood(text, option, "WIDTHxHEIGHT in pixels, each 1 to 32768, such as 800x600");
  }
  return size;
}

Pixel pixel_from(std::string_view text, const std::string& option) {
  const auto parts = split(text, ',');
  Pixel pixel{0, 0};
  if (parts.size() != 2 || !parse_whole(parts[0], pixel.x) || !parse_whole(parts[1], pixel.y)) {
    not_understood(text, option, "two whole numbers x,y, such as 320,240");
  }
  return pixel;
}

std::uint64_t whole_number_from(std::string_view text, const std::string& option) {
  std::uint64_t value = 0;
  if (!parse_whole(text, value)) not_understood(text, option, "a whole number such as 12");
  return value;
}

velum::Rect rect_from(std::string_view text, const std::string& option) {
  const auto parts = split(text, ',');
  velum::Rect rect;
  if (parts.size() != 4 || !parse_whole(parts[0], rect.left) || !parse_whole(parts[1], rect.top) ||
      !parse_whole(parts[2], rect.width) || !parse_whole(parts[3], rect.height) || rect.is_empty()) {
    not_understood(text, option, "X,Y,W,H in whole pixels with W and H at least 1, such as 10,20,64,64");
  }
  return rect;
}

velum::Rgba8 colour_from(std::string_view text, const std::string& option) {
  if (text == "transparent") return {0, 0, 0, 0};
  unsigned value = 0;
  if (text.size() != 7 || text[0] != '#' || text[1] == '+' || !parse_whole(text.substr(1), value, 16)) {
    not_understood(text, option, "\"transparent\" or \"#rrggbb\" in hexadecimal, such as \"#ffffff\"");
  }
  const auto byte = [value](int shift) { return static_cast<std::uint8_t>((value >> shift) & 0xffu); };
  return {byte(16), byte(8), byte(0), 255};
}

}  // namespace velum_app
