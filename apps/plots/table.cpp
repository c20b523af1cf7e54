#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace velum_plots {
namespace {

/// How many characters of UTF-8 text are seen.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & '\xC0') != '\x80'; }));
}

std::vector<std::size_t> widths(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> result(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) result[i] = std::max(result[i], width_of(row[i]));
  }
  return result;
}

std::string padded(const std::string& text, std::size_t width, bool is_left) {
  const std::string space(width - width_of(text), ' ');
  return is_left ? text + space : space + text;
}

std::string joined(const std::vector<std::string>& cells, const std::vector<std::size_t>& width,
                   const std::string& sides, const std::string& between) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += (i == 0 ? "" : between) + padded(cells[i], width[i], sides[i] == 'l');
  return line;
}

}  // namespace

std::string Table::text() const {
  const auto width = widths(rows_);
  std::string all;
  for (const auto& row : rows_) {
    all += joined(row, width, sides_, "  ");
    all.erase(all.find_last_not_of(' ') + 1);
    all += "\n";
  }
  return all;
}

std::string Table::markdown() const {
  const auto width = widths(rows_);
  std::string all;
  for (const auto& row : rows_) {
    all += "| " + joined(row, width, sides_, " | ") + " |\n";
    if (&row != &rows_.front()) continue;
    for (std::size_t i = 0; i < row.size(); ++i)
      all += "|" + std::string(width[i] + 1, '-') + (sides_[i] == 'l' ? "-" : ":");
    all += "|\n";
  }
  return all;
}

std::string Table::html() const {
  std::string all = "<table>\n";
  for (const auto& row : rows_) {
    const std::string tag = &row == &rows_.front() ? "th" : "td";
    all += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      all += "<" + tag + (sides_[i] == 'l' ? "" : " class=\"number\"") + ">" + escaped(row[i]) + "</" + tag +
             ">";
    }
    all += "</tr>\n";
  }
  return all + "</table>\n";
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else
      result += c;
  }
  return result;
}

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string fixed_down(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return fixed(std::floor(value * scale) / scale, digits);
}

std::string fixed_up(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return fixed(std::ceil(value * scale) / scale, digits);
}

std::string fixed_range(double least, double most, int digits) {
  const std::string from = fixed(least, digits), to = fixed(most, digits);
  return from == to ? from : from + " … " + to;
}

std::string short_figure(double value) {
  const double size = std::abs(value);
  return fixed(value, size < 0.9995 ? 3 : size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
}

std::string tick_label(double value) {
  char text[64];
  const double scale = value >= 1e6 ? 1e6 : value >= 1e3 ? 1e3 : 1.0;
  std::snprintf(text, sizeof text, "%.6g%s", value / scale, value >= 1e6 ? " M" : value >= 1e3 ? " k" : "");
  return text;
}

std::string with_prefix(double value, const std::string& unit) {
  if (value >= 1e9) return short_figure(value / 1e9) + " G" + unit;
  if (value >= 1e6) return short_figure(value / 1e6) + " M" + unit;
  if (value >= 1e3) return short_figure(value / 1e3) + " k" + unit;
  return short_figure(value) + " " + unit;
}

}  // namespace velum_plots
