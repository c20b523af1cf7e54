#include "text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace velum_app {
namespace {

template <typename... Form>
std::string text_of(double value, Form... form) {
  std::array<char, 400> buffer;  // the largest double has 309 digits before the point
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, form...);
  return std::string(buffer.data(), result.ptr);
}

bool is_minus_zero(const std::string& text) {
  return text[0] == '-' && text.find_first_of("123456789i") == std::string::npos;
}

}  // namespace

std::string number_text(double value, int digits) {
  const std::string text = text_of(value, std::chars_format::general, digits);
  return is_minus_zero(text) ? "0" : text;
}

std::string fixed_text(double value, int decimals) {
  const std::string text = text_of(value, std::chars_format::fixed, decimals);
  return is_minus_zero(text) ? text.substr(1) : text;
}

std::string grouped_text(std::uint64_t value) {
  std::string text = std::to_string(value);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

std::string counted_text(std::uint64_t count, const std::string& noun) {
  return grouped_text(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string primitives_text(std::uint64_t triangles, std::uint64_t segments, std::uint64_t points) {
  std::string text;
  const auto append = [&text](std::uint64_t count, const std::string& noun) {
    text += (text.empty() ? "" : ", ") + counted_text(count, noun);
  };
  if (triangles > 0 || segments + points == 0) append(triangles, "triangle");
  if (segments > 0) append(segments, "segment");
  if (points > 0) append(points, "point");
  return text;
}

std::string percent_text(double share) {
  const double percent = share * 100.0;
  if (percent > 0.0 && percent < 0.1) return "< 0.1 %";
  if (percent > 0.0 && percent < 1.0) return fixed_text(percent, 1) + " %";
  return fixed_text(percent, 0) + " %";
}

std::size_t text_width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

std::string padded_left(const std::string& text, std::size_t width) {
  const std::size_t has = text_width(text);
  return (has < width ? std::string(width - has, ' ') : std::string()) + text;
}

std::string padded_right(const std::string& text, std::size_t width) {
  const std::size_t has = text_width(text);
  return text + (has < width ? std::string(width - has, ' ') : std::string());
}

}  // namespace velum_app
