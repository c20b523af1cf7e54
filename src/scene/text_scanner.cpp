#include "text_scanner.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>

#include "../base/error.hpp"

namespace velum {
namespace {

bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// "+1" is a number in every format read here, but not for from_chars; "+-1" stays none.
std::string_view without_plus(std::string_view token) {
  const bool has_plus = token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+';
  return has_plus ? token.substr(1) : token;
}

// Newer versions of fast_float report overflow and underflow as an error, with the rounded value all the
// same.
template <typename T>
std::optional<T> parse_real(std::string_view token) {
  token = without_plus(token);
  const char* end = token.data() + token.size();
  T value{};
  const auto result = fast_float::from_chars(token.data(), end, value);
  const bool is_understood = result.ec == std::errc() || result.ec == std::errc::result_out_of_range;
  if (!is_understood || result.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<float> parse_float(std::string_view token) {
  return parse_real<float>(token);
}

std::optional<double> parse_double(std::string_view token) {
  return parse_real<double>(token);
}

std::optional<std::int64_t> parse_integer(std::string_view token) {
  token = without_plus(token);
  const char* end = token.data() + token.size();
  std::int64_t value = 0;
  const auto result = std::from_chars(token.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

std::string quoted(std::string_view token) {
  constexpr std::size_t longest = 40;
  std::string text = "\"";
  for (const char c : token.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (token.size() > longest ? "…\"" : "\"");
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

TextScanner::TextScanner(std::string_view text, std::string name, TextDialect dialect)
    : text_(text), name_(std::move(name)), dialect_(dialect) {
  constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
  if (text_.substr(0, utf8_mark.size()) == utf8_mark) position_ = utf8_mark.size();
}

bool TextScanner::is_joined_at(std::size_t i) const {
  return dialect_.continuation && text_[i] == '\\' && i + 1 < text_.size() && is_line_end(text_[i + 1]);
}

std::size_t TextScanner::after_line_end(std::size_t i) const {
  return text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n' ? i + 2 : i + 1;
}

void TextScanner::skip_blanks() {
  while (position_ < text_.size()) {
    if (is_blank(text_[position_])) {
      ++position_;
    } else if (is_joined_at(position_)) {
      position_ = after_line_end(position_ + 1);
      ++line_;
    } else {
      return;
    }
  }
}

std::string_view TextScanner::token() {
  skip_blanks();
  if (position_ < text_.size() && dialect_.comment != '\0' && text_[position_] == dialect_.comment) {
    while (position_ < text_.size() && !is_line_end(text_[position_])) ++position_;
  }
  const std::size_t first = position_;
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (is_blank(c) || is_line_end(c) || is_joined_at(position_)) break;
    ++position_;
  }
  return text_.substr(first, position_ - first);
}

std::string_view TextScanner::word() {
  while (true) {
    const std::string_view result = token();
    if (!result.empty() || at_end()) return result;
    next_line();
  }
}

std::string_view TextScanner::rest_of_line() {
  skip_blanks();
  const std::size_t first = position_;
  while (position_ < text_.size() && !is_line_end(text_[position_])) ++position_;
  std::size_t last = position_;
  while (last > first && is_blank(text_[last - 1])) --last;
  return text_.substr(first, last - first);
}

void TextScanner::next_line() {
  while (position_ < text_.size() && !is_line_end(text_[position_])) ++position_;
  if (position_ == text_.size()) return;
  position_ = after_line_end(position_);
  ++line_;
}

float TextScanner::number(std::string_view token, const char* what) const {
  if (const std::optional<float> value = parse_float(token)) return *value;
  if (token.empty()) fail(std::string(what) + " is missing", "complete the line, or export the file again");
  fail(std::string(what) + " is not a number: " + quoted(token),
       "write it like 1.5 or -2e-3, with a decimal point");
}

std::int64_t TextScanner::integer(std::string_view token, const char* what) const {
  if (const std::optional<std::int64_t> value = parse_integer(token)) return *value;
  if (token.empty()) fail(std::string(what) + " is missing", "complete the line, or export the file again");
  fail(std::string(what) + " is not a whole number: " + quoted(token),
       "correct it, or export the file again");
}

std::string TextScanner::where() const {
  return name_ + ":" + std::to_string(line_);
}

void TextScanner::fail(const std::string& problem, const std::string& remedy) const {
  throw Error(ErrorKind::read, problem, where(), remedy);
}

}  // namespace velum
