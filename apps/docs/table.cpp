#include "table.hpp"

#include <algorithm>

#include "text.hpp"

namespace velum_docs {

using velum_app::padded_left;
using velum_app::padded_right;

void Table::add(std::vector<std::string> row) {
  row.resize(rows_.front().size());
  rows_.push_back(std::move(row));
}

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> widths(rows_.front().size(), 3);
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], velum_app::text_width(row[i]));
  }
  return widths;
}

std::string Table::markdown() const {
  const std::vector<std::size_t> width = widths();
  std::string text;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    text += "|";
    for (std::size_t i = 0; i < width.size(); ++i)
      text +=
          " " + (i == 0 ? padded_right(rows_[r][i], width[i]) : padded_left(rows_[r][i], width[i])) + " |";
    text += "\n";
    if (r > 0) continue;
    text += "|";
    for (std::size_t i = 0; i < width.size(); ++i)
      text += i == 0 ? std::string(width[i] + 2, '-') + "|" : std::string(width[i] + 1, '-') + ":|";
    text += "\n";
  }
  return text;
}

std::string Table::text() const {
  std::vector<std::size_t> width(rows_.front().size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], velum_app::text_width(row[i]));
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += (i == 0 ? "" : "  ") + padded_left(row[i], width[i]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return fenced(text);
}

std::string fenced(const std::string& text) {
  return "```text\n" + text + "```\n";
}

}  // namespace velum_docs
