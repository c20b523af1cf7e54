#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace velum_plots {

/// Text in rows and columns, for people.
class Table {
 public:
  /// @param sides  one letter per column: l where it is aligned left, r right
  Table(std::vector<std::string> headings, std::string sides)
      : sides_(std::move(sides)), rows_{std::move(headings)} {}
  /// @pre as many cells as headings
  void add(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  /// Columns of equal width.
  std::string text() const;
  std::string markdown() const;
  std::string html() const;

 private:
  std::string sides_;
  std::vector<std::vector<std::string>> rows_;  ///< the first: the headings
};

/// Text in which nothing is markup, for HTML and SVG.
std::string escaped(const std::string& text);

/// printf's %.Nf
std::string fixed(double value, int digits);
/// The same, rounded to what "at least" and "at most" may truly be said of.
std::string fixed_down(double value, int digits);
std::string fixed_up(double value, int digits);
/// "54.8 … 55.2"; or one number where both read the same.
std::string fixed_range(double least, double most, int digits);
/// About three digits: "0.123", "1.23", "12.3", "123", "1235".
std::string short_figure(double value);
/// As short as the figure allows: "0.5", "20", "10 M".
std::string tick_label(double value);
/// About three digits with the unit and its prefix, e.g. "24.1 GB/s" of 24.1e9.
std::string with_prefix(double value, const std::string& unit);

}  // namespace velum_plots
