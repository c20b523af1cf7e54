#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace velum {

/// The number a whole token spells, rounded to nearest once, whatever the locale; a leading '+', "inf" and
/// "nan" are understood, what is too large becomes infinite. Empty when the token is not a number.
std::optional<float> parse_float(std::string_view token);
std::optional<double> parse_double(std::string_view token);
/// Decimal digits with an optional sign. Empty when the token is not that, or does not fit 64 bits.
std::optional<std::int64_t> parse_integer(std::string_view token);

/// The token between quotation marks for a message: shortened, with unprintable bytes as '?'.
std::string quoted(std::string_view token);

/// ASCII letters only.
bool equal_ignoring_case(std::string_view a, std::string_view b);

/// What stands out in a text dialect.
struct TextDialect {
  char comment = '\0';        ///< a token that begins so ends the line; '\0': there are no comments
  bool continuation = false;  ///< a backslash before the line end joins the next line
};

/// Walks over the lines and tokens of a text in memory, which it views. Lines end in LF, CR LF or CR.
class TextScanner {
 public:
  /// @param name  shown in errors as "name:line"
  TextScanner(std::string_view text, std::string name, TextDialect dialect = {});

  bool at_end() const { return position_ >= text_.size(); }
  std::size_t line() const { return line_; }
  /// Bytes from the start of the text to the cursor.
  std::size_t position() const { return position_; }

  /// The next token of this line; empty at its end.
  std::string_view token();
  /// The next token, on this line or a later one; empty at the end of the text.
  std::string_view word();
  /// What is left of this line, without blanks around it; comments are not looked for.
  std::string_view rest_of_line();
  /// Moves behind the end of this line.
  void next_line();

  /// The token as a number. @param what  names the number in the error
  /// @throws Error (read) with file:line when the token is missing or not a number
  float number(std::string_view token, const char* what) const;
  std::int64_t integer(std::string_view token, const char* what) const;

  std::string where() const;
  [[noreturn]] void fail(const std::string& problem, const std::string& remedy = {}) const;

 private:
  void skip_blanks();
  bool is_joined_at(std::size_t i) const;
  std::size_t after_line_end(std::size_t i) const;

  std::string_view text_;
  std::string name_;
  TextDialect dialect_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};

}  // namespace velum
