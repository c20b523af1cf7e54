#include "scene/text_scanner.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"

using velum::parse_float;
using velum::parse_integer;
using velum::TextScanner;

TEST_CASE("numbers are rounded once, to nearest, ties to even") {
  CHECK(parse_float("0.1") == 0.1f);
  CHECK(parse_float("1e-45") == std::numeric_limits<float>::denorm_min());
  CHECK(parse_float("7.1e-46") == std::numeric_limits<float>::denorm_min());
  CHECK(parse_float("7.0e-46") == 0.0f);
  CHECK(parse_float("3.4028235e38") == std::numeric_limits<float>::max());
  CHECK(parse_float("3.4028236e38") == std::numeric_limits<float>::infinity());
  CHECK(parse_float("-1e999") == -std::numeric_limits<float>::infinity());
  CHECK(parse_float("16777217") == 16777216.0f);
  CHECK(parse_float("16777219") == 16777220.0f);
  // Halfway between 1 and its successor, and a last digit far behind that decides.
  const std::string halfway = "1.000000059604644775390625";
  CHECK(parse_float(halfway) == 1.0f);
  CHECK(parse_float(halfway + std::string(700, '0') + "1") == std::nextafter(1.0f, 2.0f));
  // Halfway also for double: rounding to double first and to float then would give 1.
  CHECK(parse_float("1.00000005960464477539062500000001") == std::nextafter(1.0f, 2.0f));
  CHECK(std::bit_cast<std::uint32_t>(*parse_float("-0")) == 0x80000000u);
}

TEST_CASE("the forms of numbers") {
  CHECK(parse_float("+1.5") == 1.5f);
  CHECK(parse_float("2.") == 2.0f);
  CHECK(parse_float(".5") == 0.5f);
  CHECK(parse_float("1E2") == 100.0f);
  CHECK(parse_float("1e+2") == 100.0f);
  CHECK(std::isnan(*parse_float("nan")));
  for (const char* none : {"", "+", "-", "+-1", "++1", "1,5", "1.5x", "0x10", "1e", "--1", "e5", "."}) {
    CAPTURE(none);
    CHECK_FALSE(parse_float(none).has_value());
  }
  CHECK(parse_integer("+7") == 7);
  CHECK(parse_integer("-9223372036854775808") == std::numeric_limits<std::int64_t>::min());
  for (const char* none : {"", "+", "1.0", "9223372036854775808", "7x", "+-1"}) {
    CAPTURE(none);
    CHECK_FALSE(parse_integer(none).has_value());
  }
}

TEST_CASE("a comma-decimal locale changes no number") {
  const char* found = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"}) {
    if (found == nullptr) found = std::setlocale(LC_ALL, name);
  }
  if (found == nullptr) MESSAGE("no such locale is installed; the numbers are read all the same");
  CHECK(parse_float("1.5") == 1.5f);
  CHECK_FALSE(parse_float("1,5").has_value());
  std::setlocale(LC_ALL, "C");
}

TEST_CASE("lines end in LF, CR LF and CR, and are counted") {
  TextScanner scanner(
      "\xEF\xBB\xBF"
      "a b\r\nc\rd\n\ne",
      "file");
  CHECK(scanner.token() == "a");
  CHECK(scanner.token() == "b");
  CHECK(scanner.token().empty());
  CHECK(scanner.word() == "c");
  CHECK(scanner.line() == 2);
  CHECK(scanner.word() == "d");
  CHECK(scanner.line() == 3);
  CHECK(scanner.word() == "e");
  CHECK(scanner.where() == "file:5");
  CHECK(scanner.word().empty());
  CHECK(scanner.at_end());
}

TEST_CASE("comments and continued lines are the dialect's") {
  const char* text = "f 1 2\\\n 3 # four\\\ng a#b  \n";
  TextScanner scanner(text, "file", {'#', true});
  for (const char* expected : {"f", "1", "2", "3", ""}) CHECK(scanner.token() == expected);
  scanner.next_line();
  CHECK(scanner.line() == 3);
  CHECK(scanner.token() == "g");
  CHECK(scanner.rest_of_line() == "a#b");
  TextScanner plain(text, "file");
  for (const char* expected : {"f", "1", "2\\", ""}) CHECK(plain.token() == expected);
}

TEST_CASE("a wrong number names file, line and text") {
  TextScanner scanner("1\n2 abc\x01", "m.obj");
  scanner.next_line();
  CHECK(scanner.number(scanner.token(), "a coordinate") == 2.0f);
  CHECK_THROWS_WITH_AS(
      scanner.number(scanner.token(), "a coordinate"),
      "m.obj:2: a coordinate is not a number: \"abc?\"; write it like 1.5 or -2e-3, with a decimal point",
      velum::Error);
}
